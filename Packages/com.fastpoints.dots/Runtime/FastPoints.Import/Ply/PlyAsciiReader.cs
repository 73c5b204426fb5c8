using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Ply
{
    // A vertex is a line. Lines end in LF, CR or CR LF, and blank lines do not count. Vertices over several lines, or several in
    // one line, are not supported (nor are they by the usual readers).
    sealed class PlyAsciiReader : LineReader
    {
        const int MaxBlockBytes = 1 << 20;

        readonly PlyFile m_ply;
        readonly bool m_hasVerticesAlone = true;

        // As claimed.
        readonly ulong m_rowsBefore;

        public PlyAsciiReader(PlyFile ply) : base(ply.Info, ply.Handle, ply.Header.DataOffset)
        {
            m_ply = ply;
            var header = ply.Header;
            for (int i = 0; i < header.Elements.Count; i++)
            {
                if (i == header.VertexIndex || header.Elements[i].Properties.Count == 0 || header.Elements[i].Count == 0)
                    continue;
                m_hasVerticesAlone = false;
                if (i < header.VertexIndex)
                    m_rowsBefore = Sum(m_rowsBefore, header.Elements[i].Count);
            }
            AreAllFound = ply.Vertex.Count == 0;
            if (AreAllFound)
                Info.PointsReadable = Blocks.Take(Array.Empty<SegmentBlock>());
        }

        // Not if there are faces as well, whose lines look alike.
        public override bool HasPrefixes => m_hasVerticesAlone && base.HasPrefixes;

        private protected override void BlocksFound() => Info.PointsReadable = PointCount;

        public override IEnumerator<JobStep> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var scan = new AsciiRowScan(this, File, m_ply.Header.DataOffset, MaxBlockBytes, m_rowsBefore,
                Sum(m_rowsBefore, m_ply.Vertex.Count));
            while (scan.Next(out var handle))
                yield return handle;
            m_ply.SetPointCount(scan.Points, Info.FileBytes, "the file ends before");
            Info.PointsReadable = Blocks.Take(scan.TakeBlocks());
            AreAllFound = true;
            m_ply.ForgetBroken();
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new PlyRead(this, m_ply, Blocks, wanted, capacity, allocator);

        static ulong Sum(ulong a, ulong b) => a <= ulong.MaxValue - b ? a + b : ulong.MaxValue;
    }
}
