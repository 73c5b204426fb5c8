using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Potree 2: metadata.json, with hierarchy.bin and octree.bin beside it, encodings DEFAULT and BROTLI.
    // hierarchy.bin is a sequence of 22-byte records in pages; a page holds some levels below its root, breadth first:
    //
    // byte 0     1           2..5          6..13            14..21
    //      type  child mask  points (u32)  byte offset      byte count
    //
    // Offset and count are of octree.bin, or of the page in hierarchy.bin for a proxy (type 2), whose page repeats it as its
    // first record. Converters do not distinguish types 0 and 1 (leaf). A node that claims points and has no bytes is empty:
    // PotreeConverter writes such (potree issue 1125).
    internal sealed class Potree2Reader : PotreeReader
    {
        const string HierarchyName = "hierarchy.bin", OctreeName = "octree.bin";
        const int RecordBytes = 22;
        const int Proxy = 2;
        const int StepRecords = 4096;

        // More than Brotli packs into a byte, even equal points: 20,000 equal points take some 60 bytes.
        const int MaxPointsPerByte = 1000;
        const long MaxStreamBytes = 1 << 27; // A slot holds a node's Brotli stream whole.

        readonly string m_hierarchyPath;
        readonly long m_hierarchyBytes;
        readonly long m_octreeBytes;
        readonly SourceHandle m_octree;
        readonly Queue<(int Level, int3 Cell)> m_nodesOfPage = new Queue<(int, int3)>();
        ByteReader m_records;
        long m_recordOffset;
        long m_pageOffset;
        int4 m_pageRoot;
        long m_pageEnd;
        long m_recordsLeft;
        long m_nodesLost;
        long m_octreeBytesClaimed;
        bool m_isPageRoot;

        Potree2Reader(Potree2Metadata metadata, string hierarchyPath, long hierarchyBytes, long octreeBytes)
            : base(metadata.Info, metadata.Cube, metadata.Spacing)
        {
            m_hierarchyPath = hierarchyPath;
            m_hierarchyBytes = hierarchyBytes;
            Layout = metadata.Layout;
            IsBrotli = metadata.IsBrotli;
            m_octree = new SourceHandle(SourcePath.Full(SiblingOf(metadata.Info.Path, OctreeName)));
            m_octreeBytes = octreeBytes;
            m_recordsLeft = hierarchyBytes / RecordBytes;
            m_records = new ByteReader(Array.Empty<byte>(), hierarchyPath, 0);
            Pages.Add(default, 0, Math.Min(metadata.FirstChunkBytes, hierarchyBytes));
        }

        internal static Potree2Reader Open(JsonMembers json)
        {
            var metadata = Potree2Metadata.Read(json);
            string path = SiblingOf(json.Path, HierarchyName);
            long bytes;
            using (var hierarchy = RandomAccessFile.Open(path))
                bytes = hierarchy.Length;
            long octreeBytes = RandomAccessFile.LengthOf(SiblingOf(json.Path, OctreeName));
            metadata.Info.FileBytes += bytes + Math.Max(0, octreeBytes);
            if (octreeBytes < 0)
                metadata.Info.Warn(-1, "there is no " + OctreeName
                    + " beside it: the hierarchy can be shown, but there are no points to read");
            return WithFirstLevel(new Potree2Reader(metadata, path, bytes, octreeBytes));
        }

        public override bool HasCheapRanges => !IsBrotli;

        internal bool IsBrotli { get; }

        internal override PotreeLayout Layout { get; }

        bool HasPoints => m_octreeBytes >= 0;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            if (!HasPoints)
                throw new PointCloudException(FailureCode.NotFound, SiblingOf(Info.Path, OctreeName), -1,
                    "no such file: the points that " + SourcePath.NameOf(Info.Path) + " tells of are not here");
            return IsBrotli
                ? (BlockRead)new PotreeBrotliRead(this, wanted, capacity, allocator)
                : new PotreeRecordRead(this, wanted, capacity, allocator);
        }

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = Block(block).Offset;
            return m_octree.Path;
        }

        internal override JobHandle BeginRead(NativeFileRead read, in FilePiece piece) =>
            read.Begin(m_octree, piece.OffsetBytes, (int)piece.LengthBytes);

        internal override int3 ShiftOf(int block) => default;

        public override void CloseFile() => m_octree.Close();

        public override bool IsKnownBelow(int4 node, int levels) => Tree.IsHierarchyRead || !Pages.TryPeek(node, levels, out _);

        // The page has another record whose bytes have not been used before.
        bool HasRecord => m_recordsLeft > 0 && m_recordOffset + RecordBytes <= m_pageEnd;

        bool IsRecordRead => m_recordOffset >= m_records.FileOffset &&
            m_recordOffset + RecordBytes <= m_records.FileOffset + m_records.Length;

        private protected override IEnumerator<JobStep> ReadPages(int4 node, int levels)
        {
            int done = 0;
            while (m_nodesOfPage.Count > 0 || BeginPage(node, levels))
            {
                if (HasRecord && !IsRecordRead)
                    yield return JobStep.Of(PoolTask.Run(m_hierarchyPath, ReaderOf(m_recordOffset), KeepRecords));
                for (; m_nodesOfPage.Count > 0 && HasRecord && IsRecordRead && done < StepRecords; done++)
                    ReadRecord();
                if (m_nodesOfPage.Count == 0 || !HasRecord)
                    EndPage();
                if (done < StepRecords)
                    continue;
                yield return default;
                done = 0;
            }
            Tree.IsHierarchyRead = Pages.Count == 0;
        }

        bool BeginPage(int4 node, int levels)
        {
            if (!Pages.TryPeek(node, levels, out var page))
                return false;
            Pages.Remove(page);
            Tree.PageCount++;
            m_pageOffset = m_recordOffset = page.Offset;
            m_pageEnd = page.Offset + page.Bytes;
            m_isPageRoot = true;
            m_pageRoot = page.Root;
            m_nodesOfPage.Enqueue((page.Root.w, page.Root.xyz));
            return true;
        }

        // More than a page usually has, so that the next page is often included.
        Func<ByteReader> ReaderOf(long start)
        {
            string path = m_hierarchyPath;
            return () =>
            {
                using var hierarchy = RandomAccessFile.Open(path);
                return hierarchy.ReadUpTo(start, StepRecords * RecordBytes);
            };
        }

        void KeepRecords(ByteReader records)
        {
            m_records = records;
            // The file is shorter than it was at opening.
            if (!IsRecordRead)
                m_pageEnd = m_recordOffset;
        }

        // All its nodes are read, or there are no more records for the others.
        void EndPage()
        {
            m_nodesLost += m_nodesOfPage.Count;
            m_nodesOfPage.Clear();
            if (m_nodesLost > 0)
                Warnings.Add("the page of the hierarchy that begins with it ends early",
                    PotreeNames.NameOf(m_pageRoot.w, m_pageRoot.xyz),
                    NumberText.Of(m_nodesLost) + " nodes and what lies below them are left out", m_pageOffset, m_hierarchyPath);
            m_nodesLost = 0;
        }

        void ReadRecord()
        {
            var (level, cell) = m_nodesOfPage.Dequeue();
            int at = (int)(m_recordOffset - m_records.FileOffset);
            m_recordOffset += RecordBytes;
            m_recordsLeft--;
            int type = m_records.UInt8(at, "node type");
            int mask = m_records.UInt8(at + 1, "child mask");
            long points = m_records.UInt32(at + 2, "points");
            long offset = (long)m_records.UInt64(at + 6, "byte offset");
            long bytes = (long)m_records.UInt64(at + 14, "byte count");
            long where = m_records.FileOffset + at;
            bool isPageRoot = m_isPageRoot;
            m_isPageRoot = false;
            if (type == Proxy)
            {
                AddPage(level, cell, offset, bytes, where, isPageRoot);
                return;
            }
            if (WarnIfFull(where))
            {
                m_nodesOfPage.Clear();
                Pages.Clear();
                m_nodesLost = 0;
                return;
            }
            Add(level, cell, points, offset, bytes, where);
            if (mask != 0 && level == MaxLevels)
                Warnings.Add("has children below the deepest level that is read", PotreeNames.NameOf(level, cell), null, where,
                    m_hierarchyPath);
            // The list is limited to what the page can have records for, so that false masks take no memory.
            long room = (m_pageEnd - where) / RecordBytes - 1;
            for (int child = 0; child < 8 && level < MaxLevels; child++)
                if ((mask >> child & 1) == 0)
                    continue;
                else if (m_nodesOfPage.Count >= room)
                    m_nodesLost++;
                else
                    m_nodesOfPage.Enqueue((level + 1, PotreeNames.Child(cell, child)));
        }

        void AddPage(int level, int3 cell, long offset, long bytes, long where, bool isPageRoot)
        {
            bool isInFile = offset >= 0 && bytes >= RecordBytes && offset <= m_hierarchyBytes - RecordBytes;
            if (!isInFile || isPageRoot || m_recordsLeft <= 0)
            {
                Warnings.Add("the page of the hierarchy that it hangs on is not there", PotreeNames.NameOf(level, cell),
                    "wanted " + NumberText.Of(bytes) + " bytes at byte " + NumberText.Of(offset)
                        + (isPageRoot ? ", which is itself" : ""), where,
                    m_hierarchyPath);
                return;
            }
            Pages.Add(new int4(cell, level), offset, Math.Min(bytes, m_hierarchyBytes - offset));
        }

        // With those of its points that octree.bin holds.
        void Add(int level, int3 cell, long points, long offset, long bytes, long where)
        {
            if (bytes == 0)
                points = 0;
            PointsClaimed += points;
            string problem = points > 0 ? FindProblem(ref points, offset, bytes) : null;
            if (problem != null)
                Warnings.Add("its points cannot be as the hierarchy says", PotreeNames.NameOf(level, cell), problem, where,
                    m_hierarchyPath);
            if (points > 0 && HasPoints)
                m_octreeBytesClaimed += bytes;
            AddNode(level, cell, points, offset, bytes, IsBrotli ? 0 : Layout.RecordBytes);
        }

        // points: the claimed number; becomes the possible one.
        string FindProblem(ref long points, long offset, long bytes)
        {
            long claimed = points;
            string detail = "wanted " + NumberText.Of(points) + " points in " + NumberText.Of(bytes) + " bytes at byte "
                + NumberText.Of(offset) + ", got ";
            // Without octree.bin the claims are shown as they are.
            long room = HasPoints ? m_octreeBytes : long.MaxValue;
            if (offset < 0 || bytes < 0 || offset > room || bytes > room - m_octreeBytesClaimed)
            {
                points = 0;
                return detail + (bytes <= room && offset <= room && offset >= 0
                    ? "bytes that other nodes have taken" : NumberText.Of(room) + " bytes in the file");
            }
            if (IsBrotli)
            {
                bool isCut = bytes > room - offset;
                long max = Math.Min(Math.Min(MaxNodePoints, MaxNodeBytes / Layout.RecordBytes),
                    bytes > MaxStreamBytes ? 0 : bytes * MaxPointsPerByte);
                if (isCut || points > max)
                    points = 0;
                return points > 0 ? null : detail + (isCut ? NumberText.Of(room - offset) + " bytes before the end of the file"
                    : "room for " + NumberText.Of(max));
            }
            points = Math.Min(points, Math.Min(bytes, room - offset) / Layout.RecordBytes);
            return points == claimed ? null : detail + "room for " + NumberText.Of(points);
        }

        static string SiblingOf(string index, string name) => SourcePath.Combine(SourcePath.FolderOf(index) ?? "", name);
    }
}
