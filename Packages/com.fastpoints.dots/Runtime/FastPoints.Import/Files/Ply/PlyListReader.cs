using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Files
{
    /// <summary>A binary PLY file whose vertices have lists: one walk through the file finds where blocks of them
    /// start.</summary>
    sealed class PlyListReader : PlyReader
    {
        PlyBlock[] m_blocks;
        int m_maxPoints;
        int m_maxBytes;

        public PlyListReader(PlyHeader header, SourceInfo info)
            : base(header, info)
        {
            if (Vertex.Count == 0)
                Take(Array.Empty<PlyBlock>());
        }

        public override bool BlocksAreKnown => m_blocks != null;
        public override int BlockCount => Found().Length;
        public override int MaxPointsPerBlock => Found().Length == 0 ? 0 : m_maxPoints;
        internal int MaxBlockBytes => m_maxBytes;
        internal bool IsBigEndian => Header.Encoding == PlyEncoding.BinaryBigEndian;

        public override long FirstPointOfBlock(int block) => Found()[block].FirstPoint;

        public override int PointsInBlock(int block) => Found()[block].Points;

        /// <summary>Any range reads its whole block: the positions of vertices in it are not recorded.</summary>
        public override long BytesOfRange(BlockRange range) => range.Count == 0 ? 0 : Found()[range.Block].Bytes;

        public override IEnumerator<Work> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using (var walk = new PlyElementWalk(this, true))
            {
                while (walk.Next(out var handle))
                    yield return handle;
                var end = walk.State;
                bool isBroken = end.Error != PlyError.None;
                SettlePoints(end.PointsInBlocks, isBroken ? end.ErrorOffset : end.Position,
                    isBroken ? PlyError.Text(end.Error) : null);
                Take(walk.TakeBlocks());
            }
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            Found();
            return new PlyListRead(this, wanted, capacity, allocator);
        }

        internal PlyBlock Block(int block) => m_blocks[block];

        internal List<PlyStep> Steps(PointBatch batch) => PlyPlan.Decoding(Vertex, Names, batch);

        void Take(PlyBlock[] blocks)
        {
            m_blocks = blocks;
            Info.PointsReadable = 0;
            foreach (var block in blocks)
            {
                m_maxPoints = Math.Max(m_maxPoints, block.Points);
                m_maxBytes = Math.Max(m_maxBytes, block.Bytes);
                Info.PointsReadable += block.Points;
            }
        }

        PlyBlock[] Found() => m_blocks ?? throw new InvalidOperationException("FindBlocks comes first");
    }
}
