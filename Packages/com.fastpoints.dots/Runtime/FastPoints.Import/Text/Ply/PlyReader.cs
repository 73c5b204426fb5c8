using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Text
{
    // The vertices of a PLY file, ascii or binary, as points: each scalar property is an attribute of its own type, under its
    // usual name (PlyNames) or the file's. Lists and all other elements are skipped. If a file breaks off or has a bad value, the
    // points before it are read and a warning says where. Coordinates that are not finite are kept.
    static class PlyReader
    {
        public static PointReader Open(RandomAccessFile source)
        {
            var ply = PlyFile.Read(source);
            return ply.Header.IsAscii ? new PlyAsciiReader(ply)
                : ply.Vertex.HasLists ? (PointReader)new PlyListReader(ply) : new PlyFixedReader(ply);
        }
    }

    // Vertices with lists: one walk through the file finds where blocks of them start.
    sealed class PlyListReader : SegmentReader
    {
        readonly PlyFile m_ply;

        public PlyListReader(PlyFile ply) : base(ply.Info, ply.Handle)
        {
            m_ply = ply;
            if (ply.Vertex.Count == 0)
                Info.PointsReadable = Blocks.Set(Array.Empty<SegmentBlock>());
        }

        public override bool BlocksAreKnown => Blocks.AreFound;

        public override IEnumerator<JobStep> IndexBlocks()
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
            Info.PointsReadable = Blocks.Set(walk.TakeBlocks());
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new PlyRead(this, m_ply, Blocks, wanted, capacity, allocator);
    }

    // Vertices without lists. If an element before them has lists, finding their first byte takes a walk through that element.
    sealed class PlyFixedReader : RecordReader
    {
        readonly PlyFile m_ply;

        public PlyFixedReader(PlyFile ply) : base(ply.Info, ply.Handle, ply.Vertex.FixedBytes)
        {
            m_ply = ply;
            var header = ply.Header;
            long offset = header.DataOffset;
            for (int i = 0; i < header.VertexIndex; i++)
            {
                if (header.Elements[i].HasLists)
                    return;
                offset = header.Elements[i].EndOfFixed(offset, Info.FileBytes);
            }
            StartAt(offset, null);
        }

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var walk = new PlyElementWalk(m_ply, false);
            while (walk.Next(out var handle))
                yield return handle;
            var end = walk.State;
            if (end.Error != PlyError.None)
                StartAt(Info.FileBytes + 1, "an element before them: " + PlyError.Text(end.Error));
            else
                StartAt(end.Position, null);
        }

        void StartAt(long offset, string reason)
        {
            int recordBytes = m_ply.Vertex.FixedBytes;
            long room = Math.Max(0, Info.FileBytes - offset) / recordBytes;
            long points = m_ply.Vertex.Count < (ulong)room ? (long)m_ply.Vertex.Count : room;
            m_ply.SetPointCount(points, Info.FileBytes,
                reason ?? "the file ends before (" + recordBytes + " bytes each, from byte " + offset + ")");
            SetRecords(m_ply.RecordFields(), offset, m_ply.IsBigEndian, points);
            WarnTrailingBytes(offset);
        }

        void WarnTrailingBytes(long offset)
        {
            for (int i = m_ply.Header.VertexIndex; i < m_ply.Header.Elements.Count; i++)
            {
                if (m_ply.Header.Elements[i].HasLists)
                    return;
                offset = m_ply.Header.Elements[i].EndOfFixed(offset, Info.FileBytes);
            }
            if (offset < Info.FileBytes)
                Info.Warn(offset, (Info.FileBytes - offset) + " bytes behind the last element: they are left out");
        }
    }

    // A vertex is a line. Lines end in LF, CR or CR LF, and blank lines do not count. Vertices over several lines, or several in
    // one line, are not supported (nor are they by the usual readers).
    sealed class PlyAsciiReader : LineReader
    {
        const int MaxBlockBytes = 1 << 20;

        readonly PlyFile m_ply;
        readonly bool m_hasVerticesAlone = true;
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
                Info.PointsReadable = Blocks.Set(Array.Empty<SegmentBlock>());
        }

        // Not if there are faces as well, whose lines look alike.
        public override bool HasPrefixes => m_hasVerticesAlone && base.HasPrefixes;

        private protected override void OnBlocksFound() => Info.PointsReadable = PointCount;

        public override IEnumerator<JobStep> IndexBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var scan = new AsciiRowScan(this, File, m_ply.Header.DataOffset, MaxBlockBytes, m_rowsBefore,
                Sum(m_rowsBefore, m_ply.Vertex.Count));
            while (scan.Next(out var handle))
                yield return handle;
            m_ply.SetPointCount(scan.Points, Info.FileBytes, "the file ends before");
            Info.PointsReadable = Blocks.Set(scan.TakeBlocks());
            AreAllFound = true;
            m_ply.ForgetBroken();
        }

        private protected override int BytesBehindBlock => PlyRead.MaxLineBytes;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new PlyRead(this, m_ply, Blocks, wanted, capacity, allocator);

        static ulong Sum(ulong a, ulong b) => a <= ulong.MaxValue - b ? a + b : ulong.MaxValue;
    }
}
