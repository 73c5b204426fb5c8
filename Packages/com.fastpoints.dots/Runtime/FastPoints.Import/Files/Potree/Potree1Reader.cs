using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>
    /// Reads Potree 1.4 to 1.8: cloud.js, a file a node (BIN, LAS or LAZ), and the hierarchy in cloud.js or in .hrc files.
    /// </summary>
    /// <remarks>
    /// An .hrc file holds the levels below a node, breadth first, as far as hierarchyStepSize levels down, 5 bytes a node: child
    /// mask, points (u32). The first record repeats the node itself. What a node's file holds wins over that count: converters
    /// have written other ones.
    ///
    /// Positions are integers from the corner of the node's cell, in steps of cloud.js' scale; the cloud's grid starts at the
    /// corner of its bounding box. Corners of cells lie between grid places where the box is no whole number of steps: BIN
    /// corners are rounded up, since the converter truncated (a source on this grid comes back exactly, any other within a step);
    /// those of LAS and LAZ nodes to the nearest, since it rounded (the error is then at most half a step). Such nodes are all of
    /// one point format, as their converter writes them.
    /// </remarks>
    public sealed class Potree1Reader : PotreeNodeReader
    {
        const int RecordBytes = 5;

        /// <summary>Nodes looked up in one go.</summary>
        const int StepNodes = 32;

        /// <summary>Of an .hrc file; 8^7 nodes take less.</summary>
        const int MaxHierarchyBytes = 16 << 20;

        /// <summary>Of a node that is LAS or LAZ, which a slot reads whole.</summary>
        const long MaxLasBytes = 1 << 29;

        /// <summary>What corners may lie above a grid place by rounding, in steps.</summary>
        const double CornerTolerance = 1e-5;

        /// <summary>A node whose .hrc file has not been read.</summary>
        struct Page
        {
            public int Level;
            public int3 Cell;
        }

        /// <summary>A node whose children come next in the page.</summary>
        struct Parent
        {
            public int Level;
            public int3 Cell;
            public int Mask;
        }

        readonly Potree1Files m_files;
        readonly double m_scale;
        readonly int m_stepSize;
        readonly PotreeLayout m_layout;
        readonly LasFile m_las;
        readonly List<(string Name, long Points)> m_listed;
        readonly Queue<Page> m_pages = new Queue<Page>();
        readonly Queue<Parent> m_parents = new Queue<Parent>();
        int m_listedAt;
        Page m_page;
        ByteReader m_records;
        int m_recordAt;

        Potree1Reader(Potree1Index index, Potree1Files files, PotreeLayout layout, LasFile las,
            LazFormat laz, List<(string Name, long Points)> listed) : base(index.Info, index.Cube, index.Spacing)
        {
            Laz = laz;
            m_files = files;
            m_scale = index.Scale;
            m_stepSize = index.StepSize;
            m_layout = layout;
            m_las = las;
            m_listed = listed;
            if (listed == null)
                m_pages.Enqueue(default);
        }

        /// <summary>Reads cloud.js and, where nodes are LAS or LAZ, one node's header; of the hierarchy the first page.</summary>
        /// <exception cref="PointCloudException">The index is not sound, of a version that is not read, or no node is
        /// there.</exception>
        internal static Potree1Reader Open(SourceJson json)
        {
            var index = Potree1Index.Read(json);
            var files = Potree1Files.Find(index);
            var info = index.Info;
            var listed = index.Hierarchy != null ? ReadList(index.Hierarchy, info) : null;
            PotreeLayout layout = null;
            LasFile las = null;
            LazFormat laz = null;
            if (index.NodeFormat != null)
            {
                using (var source = FileSource.Open(files.AnyNode()))
                {
                    las = LasFile.Read(source);
                    laz = las.Header.IsCompressed ? LazFormat.Read(las) : null;
                    if (laz != null && laz.Compressor == LazCompressor.None)
                        throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, LasHeader.At.PointFormat,
                            "LASzip compressor", "1 to 3", 0);
                }
                info.Schema = las.Info.Schema;
                info.Transform = las.Info.Transform;
                info.PointFormat = las.Header.PointFormat;
            }
            else
            {
                if (index.UnknownAttribute != null)
                    MeasureUnknown(index, files, listed);
                layout = new PotreeLayout(index.Attributes, json.Path);
                info.Schema = layout.Schema;
                info.RecordBytes = layout.RecordBytes;
                if (math.any(index.Cube.Size / index.Scale >= int.MaxValue))
                    throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "steps of the bounding box",
                        "less than 2^31", math.cmax(index.Cube.Size / index.Scale));
            }
            var reader = new Potree1Reader(index, files, layout, las, laz, listed);
            try
            {
                using (var steps = reader.FindLevels(1))
                    while (steps.MoveNext())
                    {
                    }
                return reader;
            }
            catch
            {
                reader.Dispose();
                throw;
            }
        }

        public override bool HasFixedStride => m_layout != null;

        internal override PotreeLayout Layout => m_layout;

        /// <summary>Of the nodes, where they are LAS or LAZ: positions and attributes that all of them must have.</summary>
        internal LasFile Las => m_las;

        /// <summary>Of the nodes, where they are LAZ; null otherwise.</summary>
        internal LazFormat Laz { get; }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) => m_layout != null
            ? (BlockRead)new PotreeRecordRead(this, wanted, capacity, allocator)
            : new PotreeLasRead(this, wanted, capacity, allocator);

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = Block(block).Offset;
            return PathOf(block);
        }

        internal override JobHandle BeginRead(NativeFileRead read, int block, long offset, int bytes) =>
            read.Begin(PathOf(block), offset, bytes);

        internal string PathOf(int block)
        {
            var node = NodeOf(block);
            return m_files.PathOf(node.Level, node.Cell);
        }

        internal override int3 ShiftOf(int block)
        {
            var node = NodeOf(block);
            var corner = Tree.Cube.Size * (double3)node.Cell / math.pow(2.0, node.Level) / m_scale;
            return (int3)math.ceil(corner - CornerTolerance);
        }

        private protected override bool ReadPage(int levels)
        {
            if (m_listed != null)
                return ReadListed();
            if (m_parents.Count == 0 && !BeginPage(levels))
                return false;
            for (int i = 0; i < StepNodes && m_parents.Count > 0; i++)
                ReadChildren(m_parents.Dequeue());
            return true;
        }

        /// <returns>Whether there is a page that the levels take.</returns>
        bool BeginPage(int levels)
        {
            if (m_pages.Count == 0)
            {
                Tree.IsWhole = true;
                return false;
            }
            // Pages are queued level by level, and all but the first begin with a node that is known.
            m_page = m_pages.Peek();
            if (m_page.Level > 0 && m_page.Level + 1 >= levels)
                return false;
            m_pages.Dequeue();
            if (!ReadRecords(m_files.HierarchyPathOf(m_page.Level, m_page.Cell)))
                return true;
            Tree.PageCount++;
            int mask = m_records.UInt8(0, "child mask");
            if (m_page.Level == 0)
                Add(0, default, m_records.UInt32(1, "points"));
            m_recordAt = RecordBytes;
            m_parents.Enqueue(new Parent { Level = m_page.Level, Cell = m_page.Cell, Mask = mask });
            return true;
        }

        bool ReadRecords(string path)
        {
            string problem;
            try
            {
                using (var source = FileSource.Open(path))
                {
                    m_records = source.ReadAtMost(0, MaxHierarchyBytes);
                    Info.FileBytes += source.Length;
                }
                if (m_records.Length >= RecordBytes)
                    return true;
                problem = "has " + Text(m_records.Length) + " bytes";
            }
            catch (PointCloudException e)
            {
                // Without the first there is no tree at all.
                if (m_page.Level == 0)
                    throw;
                problem = e.Message;
            }
            if (m_page.Level == 0)
                throw PointCloudException.Wanted(FailureCode.Truncated, path, 0, "the root's record", RecordBytes + " bytes",
                    m_records.Length);
            Findings.Tell("the hierarchy below it is not there", PotreeNames.NameOf(m_page.Level, m_page.Cell), problem);
            return false;
        }

        void ReadChildren(Parent parent)
        {
            for (int child = 0; child < 8; child++)
            {
                if ((parent.Mask >> child & 1) == 0)
                    continue;
                if (m_recordAt + RecordBytes > m_records.Length)
                {
                    Findings.Tell("the hierarchy that begins with it ends early", PotreeNames.NameOf(m_page.Level, m_page.Cell),
                        "wanted child " + Text(child) + " of " + PotreeNames.NameOf(parent.Level, parent.Cell), m_recordAt, m_records.Path);
                    m_parents.Clear();
                    return;
                }
                if (IsFull(m_recordAt))
                {
                    m_parents.Clear();
                    m_pages.Clear();
                    return;
                }
                int mask = m_records.UInt8(m_recordAt, "child mask");
                long points = m_records.UInt32(m_recordAt + 1, "points");
                m_recordAt += RecordBytes;
                int level = parent.Level + 1;
                var cell = PotreeNames.Child(parent.Cell, child);
                Add(level, cell, points);
                if (mask == 0)
                    continue;
                if (level == MaxLevels)
                    Findings.Tell("has children below the deepest level that is read", PotreeNames.NameOf(level, cell));
                else if (level == m_page.Level + m_stepSize)
                    m_pages.Enqueue(new Page { Level = level, Cell = cell });
                else
                    m_parents.Enqueue(new Parent { Level = level, Cell = cell, Mask = mask });
            }
        }

        bool ReadListed()
        {
            for (int i = 0; i < StepNodes && m_listedAt < m_listed.Count; i++, m_listedAt++)
            {
                PotreeNames.TryParse(m_listed[m_listedAt].Name, MaxLevels, out int level, out var cell);
                Add(level, cell, m_listed[m_listedAt].Points);
            }
            Tree.IsWhole = m_listedAt == m_listed.Count;
            return !Tree.IsWhole;
        }

        /// <summary>Adds a node with the points that its file has.</summary>
        /// <param name="claimed">By the hierarchy.</param>
        void Add(int level, int3 cell, long claimed)
        {
            string path = m_files.PathOf(level, cell);
            long bytes = LengthOf(path), points = 0;
            PointsClaimed += claimed;
            if (bytes < 0 && claimed > 0)
                Findings.Tell("its file is missing: its points are left out", PotreeNames.NameOf(level, cell),
                    "wanted " + Text(claimed), -1, path);
            if (bytes > 0)
            {
                Info.FileBytes += bytes;
                points = m_layout != null ? bytes / m_layout.RecordBytes : CountLas(path, level, cell);
                if (points != claimed || m_layout != null && bytes % m_layout.RecordBytes != 0)
                    Findings.Tell("its file does not hold what the hierarchy says", PotreeNames.NameOf(level, cell),
                        "wanted " + Text(claimed) + " points, got " + Text(points) + (m_layout == null ? ""
                            : " and " + Text(bytes % m_layout.RecordBytes) + " bytes"), -1, path);
            }
            AddNode(level, cell, points, 0, bytes, m_layout?.RecordBytes ?? 0);
        }

        /// <summary>Points by a node's own header, no more than its bytes can hold.</summary>
        long CountLas(string path, int level, int3 cell)
        {
            try
            {
                using (var source = FileSource.Open(path))
                {
                    var header = LasHeader.Read(source);
                    if (source.Length > MaxLasBytes)
                        throw PointCloudException.Wanted(FailureCode.Unsupported, path, -1, "bytes of a node",
                            "at most " + Text(MaxLasBytes), source.Length);
                    long most = header.IsCompressed ? LazChunk.MaxPoints(source.Length) : source.Length / header.RecordBytes;
                    most = Math.Min(most, Math.Min(MaxNodePoints, MaxNodeBytes / header.RecordBytes));
                    return (long)Math.Min(header.PointsClaimed, (ulong)most);
                }
            }
            catch (PointCloudException e)
            {
                Findings.Tell("its file cannot be read: its points are left out", PotreeNames.NameOf(level, cell), e.Message);
                return 0;
            }
        }

        /// <returns>-1 for no such file.</returns>
        static long LengthOf(string path)
        {
            try
            {
                var file = new FileInfo(path);
                return file.Exists ? file.Length : -1;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                return -1;
            }
        }

        /// <summary>The nodes that cloud.js lists, level by level, with the parents that it forgot.</summary>
        static List<(string, long)> ReadList(List<object> hierarchy, SourceInfo info)
        {
            var points = new SortedDictionary<string, long>(Comparer<string>.Create((a, b) =>
                a.Length != b.Length ? a.Length.CompareTo(b.Length) : string.CompareOrdinal(a, b)));
            int odd = 0;
            ulong claimed = 0;
            foreach (object item in hierarchy)
            {
                if (!(item is List<object> pair) || pair.Count < 2 || !(pair[0] is string name) || !JsonReader.IsNumber(pair[1])
                    || !PotreeNames.TryParse(name, MaxLevels, out _, out _) || points.TryGetValue(name, out long before) && before > 0)
                {
                    odd++;
                    continue;
                }
                double count = JsonReader.ToDouble(pair[1]);
                points[name] = (long)Math.Max(0, Math.Min(uint.MaxValue, count));
                claimed += (ulong)points[name];
                for (string parent = name.Substring(0, name.Length - 1); parent.Length > 0 && !points.ContainsKey(parent);
                    parent = parent.Substring(0, parent.Length - 1))
                    points.Add(parent, 0);
            }
            if (odd > 0)
                info.Warn(-1, "\"hierarchy\": " + Text(odd) + " entries are no name and count, or come twice: left out");
            if (info.PointsClaimed == 0)
                info.PointsClaimed = claimed;
            var list = new List<(string, long)>();
            foreach (var pair in points)
                list.Add((pair.Key, pair.Value));
            return list;
        }

        /// <summary>The length of the attribute that is not known: what the root's records have beside the others.</summary>
        /// <exception cref="PointCloudException">It cannot be told.</exception>
        static void MeasureUnknown(Potree1Index index, Potree1Files files, List<(string Name, long Points)> listed)
        {
            long bytes = LengthOf(files.PathOf(0, default)), points = 0;
            if (listed != null && listed.Count > 0)
                points = listed[0].Points;
            else if (listed == null)
                using (var source = FileSource.Open(files.HierarchyPathOf(0, default)))
                    points = source.Read(0, RecordBytes, "the root's record").UInt32(1, "points");
            long others = 0;
            foreach (var attribute in index.Attributes)
                others += attribute?.Bytes ?? 0;
            long unknown = points > 0 && bytes > 0 && bytes % points == 0 ? bytes / points - others : 0;
            if (unknown < 1 || unknown > PotreeAttribute.MaxElements)
                throw PointCloudException.Wanted(FailureCode.Unsupported, index.Info.Path, -1, "\"pointAttributes\"",
                    "names that are known", index.UnknownAttribute);
            int at = index.Attributes.IndexOf(null);
            index.Attributes[at] = PotreeAttribute.Make(index.UnknownAttribute, "uint8", (int)unknown, null, null, out _);
            index.Info.Warn(-1, "attribute \"" + index.UnknownAttribute + "\" is not known: its " + Text(unknown)
                + " bytes are read as they are");
        }

        static string Text(long number) => number.ToString(CultureInfo.InvariantCulture);
    }
}
