using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Ply
{
    // A vertex is a line. Lines end in LF, CR or CR LF, and blank lines do not count. Vertices over several lines, or several in
    // one line, are not supported (nor are they by the usual readers).
    sealed class PlyAsciiReader : SegmentReader
    {
        const int MaxBlockBytes = 1 << 20;

        readonly PlyFile m_ply;
        readonly bool m_hasVerticesAlone;

        // As claimed.
        readonly ulong m_rowsBefore;
        bool m_areAllFound;
        AsciiSegments m_segments;

        public PlyAsciiReader(PlyFile ply)
        {
            Info = ply.Info;
            m_ply = ply;
            var header = ply.Header;
            m_hasVerticesAlone = true;
            for (int i = 0; i < header.Elements.Count; i++)
            {
                if (i == header.VertexIndex || header.Elements[i].Properties.Count == 0 || header.Elements[i].Count == 0)
                    continue;
                m_hasVerticesAlone = false;
                if (i < header.VertexIndex)
                    m_rowsBefore = Sum(m_rowsBefore, header.Elements[i].Count);
            }
            if (ply.Vertex.Count == 0)
            {
                Info.PointsReadable = Blocks.Take(Array.Empty<SegmentBlock>());
                m_areAllFound = true;
            }
        }

        public override bool BlocksAreKnown => m_areAllFound;

        // Not if there are faces as well, whose lines look alike.
        public override bool HasPrefixes => !m_areAllFound && m_hasVerticesAlone
            && Info.FileBytes - m_ply.Header.DataOffset >= AsciiSegments.MinBytes;

        public override bool PrefixesAreSpread => true;
        public override int MaxPrefixes => AsciiSegments.Count;

        public override IEnumerator<JobStep> FindPrefixes() => FindPrefixes(AsciiSegments.Count);

        public override IEnumerator<JobStep> FindPrefixes(int places)
        {
            m_segments ??= new AsciiSegments(m_ply.Handle, Info.FileBytes, m_ply.Header.DataOffset);
            yield return JobStep.Of(m_segments.Find(places));
            Info.PointsReadable = Blocks.Take(m_segments.Blocks);
        }

        public override IEnumerator<JobStep> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var scan = new AsciiRowScan(this, m_ply.Handle, m_ply.Header.DataOffset, MaxBlockBytes, m_rowsBefore,
                Sum(m_rowsBefore, m_ply.Vertex.Count));
            while (scan.Next(out var handle))
                yield return handle;
            m_ply.SetPointCount(scan.Points, Info.FileBytes, "the file ends before");
            Info.PointsReadable = Blocks.Take(scan.TakeBlocks());
            m_areAllFound = true;
            m_ply.ForgetBroken();
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new PlyRead(this, m_ply, Blocks, wanted, capacity, allocator);

        public override void CloseFile() => m_ply.Handle.Close();

        static ulong Sum(ulong a, ulong b) => a <= ulong.MaxValue - b ? a + b : ulong.MaxValue;
    }
}
