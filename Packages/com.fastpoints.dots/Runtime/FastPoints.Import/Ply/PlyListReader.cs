using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Ply
{
    // Vertices with lists: one walk through the file finds where blocks of them start.
    sealed class PlyListReader : SegmentReader
    {
        readonly PlyFile m_ply;

        public PlyListReader(PlyFile ply) : base(ply.Info, ply.Handle)
        {
            m_ply = ply;
            if (ply.Vertex.Count == 0)
                Info.PointsReadable = Blocks.Take(Array.Empty<SegmentBlock>());
        }

        public override bool BlocksAreKnown => Blocks.AreFound;

        public override IEnumerator<JobStep> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var walk = new PlyElementWalk(m_ply, true);
            while (walk.Next(out var handle))
                yield return handle;
            var end = walk.State;
            bool isBroken = end.Error != PlyError.None;
            m_ply.SetPointCount(end.PointsInBlocks, isBroken ? end.ErrorOffset : end.Position,
                isBroken ? PlyError.Text(end.Error) : null);
            Info.PointsReadable = Blocks.Take(walk.TakeBlocks());
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new PlyRead(this, m_ply, Blocks, wanted, capacity, allocator);
    }
}
