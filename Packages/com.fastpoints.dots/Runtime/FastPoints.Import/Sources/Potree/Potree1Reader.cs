using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Potree 1.4 to 1.8: cloud.js, a file a node (BIN, LAS or LAZ), and the hierarchy in cloud.js or in .hrc files. An
    // .hrc file holds the levels below a node, breadth first, as far as hierarchyStepSize levels down, 5 bytes a node:
    // child mask, points (u32). The first record repeats the node itself. A node's file wins over that count:
    // converters have written wrong ones. Positions are integers from the corner of the node's cell, in steps of
    // cloud.js' scale; the cloud's grid starts at the corner of its bounding box. Corners of cells lie between grid
    // points if the box is no whole number of steps: BIN corners are rounded up, since the converter truncated (a
    // source on this grid comes back exactly, any other within a step); those of LAS and LAZ nodes to the nearest,
    // since it rounded (the error is then at most half a step).
    internal sealed class Potree1Reader : PotreeReader
    {
        const int RecordBytes = 5;
        const int StepNodes = 32;
        const int MaxHierarchyBytes = 16 << 20; // For an .hrc file; 8^7 nodes take less.
        const long MaxLasBytes = 1 << 29; // For a LAS or LAZ node, which a slot reads whole.
        const double CornerTolerance = 1e-5; // How far rounding may move corners above a grid point, in steps.

        struct Parent
        {
            public int Level;
            public int3 Cell;
            public int Mask;
        }

        readonly Potree1Files m_files;
        readonly double m_scale;
        readonly int m_stepSize;

        readonly LasTemplate m_template;
        readonly List<(string Name, long Points)> m_listed;
        readonly Queue<Parent> m_parents = new Queue<Parent>();
        readonly List<Potree1Node> m_found = new List<Potree1Node>();
        int m_listedAt;
        UnreadPage m_page;
        ByteReader m_records;
        int m_recordAt;

        Potree1Reader(Potree1Metadata metadata, Potree1Files files, PotreeLayout layout, LasTemplate template,
            List<(string Name, long Points)> listed) : base(metadata.Info, metadata.Cube, metadata.Spacing)
        {
            m_template = template;
            m_files = files;
            m_scale = metadata.Scale;
            m_stepSize = metadata.StepSize;
            Layout = layout;
            m_listed = listed;
            if (listed == null)
                Pages.Add(default);
        }

        internal static Potree1Reader Open(JsonMembers json)
        {
            var metadata = Potree1Metadata.Read(json);
            var files = Potree1Files.Find(metadata);
            var info = metadata.Info;
            var listed = metadata.Hierarchy != null ? ReadList(metadata.Hierarchy, info) : null;
            PotreeLayout layout = null;
            LasTemplate template = null;
            if (metadata.NodeFormat != null)
            {
                template = new LasTemplate(files.PathOfAnyNode());
                info.Schema = template.Las.Info.Schema;
                info.Transform = template.Las.Info.Transform;
                info.PointFormat = template.Las.Header.PointFormat;
            }
            else
            {
                if (metadata.UnknownAttribute != null)
                    MeasureUnknown(metadata, files, listed);
                layout = new PotreeLayout(metadata.Attributes, json.Path);
                info.Schema = layout.Schema;
                info.RecordBytes = layout.RecordBytes;
                if (math.any(metadata.Cube.Size / metadata.Scale >= int.MaxValue))
                    throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "steps of the bounding box",
                        "less than 2^31", math.cmax(metadata.Cube.Size / metadata.Scale));
            }
            return WithFirstLevel(new Potree1Reader(metadata, files, layout, template, listed));
        }

        public override bool HasCheapRanges => Layout != null;

        internal override PotreeLayout Layout { get; }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) => Layout != null
            ? (BlockRead)new PotreeRecordRead(this, wanted, capacity, allocator)
            : new LasNodeRead(this, m_template, true, wanted, capacity, allocator);

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = Block(block).Offset;
            var node = NodeOf(block);
            return m_files.PathOf(node.Level, node.Cell);
        }

        internal override int3 ShiftOf(int block)
        {
            var node = NodeOf(block);
            var corner = Tree.Cube.Size * (double3)node.Cell / math.pow(2.0, node.Level) / m_scale;
            return (int3)math.ceil(corner - CornerTolerance);
        }

        public override bool IsKnownBelow(int4 node, int levels) => Tree.IsHierarchyRead || !TryPeek(node, levels, out _);

        private protected override IEnumerator<JobStep> ReadPages(int4 node, int levels)
        {
            while (true)
            {
                IEnumerator<JobStep> looking;
                if (m_found.Count > 0)
                    looking = PoolTask.Run(Info.Path, FileLookup(m_found.ToArray()), AddFound);
                else if (FindNext())
                    continue;
                else if (TryPeek(node, levels, out var page))
                    looking = PoolTask.Run(Info.Path, ReaderOf(page), hierarchy => BeginPage(page, hierarchy));
                else
                    break;
                yield return JobStep.Of(looking);
            }
            Tree.IsHierarchyRead = Pages.Count == 0;
        }

        bool TryPeek(int4 node, int levels, out UnreadPage page)
        {
            // All pages except the first begin with a known node.
            return Pages.TryPeek(node, Math.Max(1, levels - 1), out page);
        }

        bool FindNext()
        {
            if (m_listed != null && m_listedAt < m_listed.Count)
                FindListed();
            else if (m_parents.Count == 0)
                return false;
            for (int i = 0; i < StepNodes && m_parents.Count > 0; i++)
                ReadChildren(m_parents.Dequeue());
            return true;
        }

        void BeginPage(UnreadPage page, Potree1Page read)
        {
            m_page = page;
            Pages.Remove(page);
            if (read.Problem != null)
            {
                // Without the first page there is no tree at all.
                if (page.Root.w == 0)
                    throw read.Problem;
                Warnings.Add("the hierarchy below it is not there", PotreeNames.NameOf(page.Root.w, page.Root.xyz),
                    read.Problem.Message);
                return;
            }
            Info.FileBytes += read.FileBytes;
            m_records = read.Records;
            Tree.PageCount++;
            int mask = m_records.UInt8(0, "child mask");
            if (page.Root.w == 0)
                Find(0, default, m_records.UInt32(1, "points"));
            m_recordAt = RecordBytes;
            m_parents.Enqueue(new Parent { Level = page.Root.w, Cell = page.Root.xyz, Mask = mask });
        }

        Func<Potree1Page> ReaderOf(UnreadPage page)
        {
            string path = m_files.HierarchyPathOf(page.Root.w, page.Root.xyz);
            return () =>
            {
                var read = new Potree1Page();
                try
                {
                    using (var source = RandomAccessFile.Open(path))
                    {
                        read.Records = source.ReadUpTo(0, MaxHierarchyBytes);
                        read.FileBytes = source.Length;
                    }
                    if (read.Records.Length < RecordBytes)
                        read.Problem = PointCloudException.Wanted(FailureCode.Truncated, path, 0, "the first node's record",
                            RecordBytes + " bytes", read.Records.Length);
                }
                catch (PointCloudException e)
                {
                    read.Problem = e;
                }
                return read;
            };
        }

        void ReadChildren(Parent parent)
        {
            for (int child = 0; child < 8; child++)
            {
                if ((parent.Mask >> child & 1) == 0)
                    continue;
                if (m_recordAt + RecordBytes > m_records.Length)
                {
                    Warnings.Add("the hierarchy that begins with it ends early",
                        PotreeNames.NameOf(m_page.Root.w, m_page.Root.xyz), "wanted child " + NumberText.Of(child) + " of " +
                        PotreeNames.NameOf(parent.Level, parent.Cell), m_recordAt, m_records.Path);
                    m_parents.Clear();
                    return;
                }
                if (WarnIfFull(m_recordAt))
                {
                    m_parents.Clear();
                    Pages.Clear();
                    return;
                }
                int mask = m_records.UInt8(m_recordAt, "child mask");
                long points = m_records.UInt32(m_recordAt + 1, "points");
                m_recordAt += RecordBytes;
                int level = parent.Level + 1;
                var cell = PotreeNames.Child(parent.Cell, child);
                Find(level, cell, points);
                if (mask == 0)
                    continue;
                if (level == MaxLevels)
                    Warnings.Add("has children below the deepest level that is read", PotreeNames.NameOf(level, cell));
                else if (level == m_page.Root.w + m_stepSize)
                    Pages.Add(new int4(cell, level));
                else
                    m_parents.Enqueue(new Parent { Level = level, Cell = cell, Mask = mask });
            }
        }

        void FindListed()
        {
            for (int i = 0; i < StepNodes && m_listedAt < m_listed.Count; i++, m_listedAt++)
            {
                PotreeNames.TryParse(m_listed[m_listedAt].Name, MaxLevels, out int level, out var cell);
                Find(level, cell, m_listed[m_listedAt].Points);
            }
        }

        void Find(int level, int3 cell, long claimed) => m_found.Add(new Potree1Node
        {
            Level = level,
            Cell = cell,
            Claimed = claimed,
            Path = m_files.PathOf(level, cell),
        });

        Func<Potree1Node[]> FileLookup(Potree1Node[] nodes)
        {
            bool isLas = Layout == null;
            long recordBytes = Layout?.RecordBytes ?? 0;
            return () =>
            {
                for (int i = 0; i < nodes.Length; i++)
                {
                    // To ask for each would take as many requests as to read all. Claims of 0 are false often enough.
                    if (nodes[i].Claimed > 0 && SourcePath.IsRemote(nodes[i].Path))
                    {
                        nodes[i].PointsOfLas = Math.Min(nodes[i].Claimed, MaxNodePoints);
                        nodes[i].Bytes = isLas ? UnknownBytes : nodes[i].Claimed * recordBytes;
                        continue;
                    }
                    nodes[i].Bytes = RandomAccessFile.LengthOf(nodes[i].Path);
                    if (isLas && nodes[i].Bytes > 0)
                        CountLas(ref nodes[i]);
                }
                return nodes;
            };
        }

        void AddFound(Potree1Node[] nodes)
        {
            m_found.Clear();
            foreach (var node in nodes)
                Add(node);
        }

        void Add(in Potree1Node node)
        {
            string name = PotreeNames.NameOf(node.Level, node.Cell);
            long points = 0;
            PointsClaimed += node.Claimed;
            if (node.Bytes == RandomAccessFile.NoSuchFile && node.Claimed > 0)
                Warnings.Add("its file is missing: its points are left out", name, "wanted " + NumberText.Of(node.Claimed), -1,
                    node.Path);
            if (node.Problem != null)
                Warnings.Add("its file cannot be read: its points are left out", name, node.Problem);
            if (node.Bytes > 0)
            {
                Info.FileBytes += node.Bytes;
                points = Layout != null ? node.Bytes / Layout.RecordBytes : node.PointsOfLas;
                // The converters wrote 0 for nodes that they had already flushed.
                if (points != node.Claimed && node.Claimed > 0 || Layout != null && node.Bytes % Layout.RecordBytes != 0)
                    Warnings.Add("its file does not hold what the hierarchy says", name,
                        "wanted " + NumberText.Of(node.Claimed) + " points, got " + NumberText.Of(points) + (Layout == null ? ""
                            : " and " + NumberText.Of(node.Bytes % Layout.RecordBytes) + " bytes"), -1, node.Path);
            }
            if (node.Bytes == UnknownBytes)
                points = node.PointsOfLas;
            AddNode(node.Level, node.Cell, points, 0, node.Bytes, Layout?.RecordBytes ?? 0);
        }

        // By a node's own header, but no more than its bytes can hold.
        static void CountLas(ref Potree1Node node)
        {
            try
            {
                using var source = RandomAccessFile.Open(node.Path);
                var header = LasHeader.Read(source);
                if (source.Length > MaxLasBytes)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, node.Path, -1, "bytes of a node",
                        "at most " + NumberText.Of(MaxLasBytes), source.Length);
                long max = header.IsCompressed ? LazChunk.MaxPoints(source.Length) : source.Length / header.RecordBytes;
                max = Math.Min(max, Math.Min(MaxNodePoints, MaxNodeBytes / header.RecordBytes));
                node.PointsOfLas = (long)Math.Min(header.PointsClaimed, (ulong)max);
            }
            catch (PointCloudException e)
            {
                node.Problem = e.Message;
            }
        }

        // Level by level, with the parents that it omitted.
        static List<(string, long)> ReadList(List<object> hierarchy, SourceInfo info)
        {
            var points = new SortedDictionary<string, long>(Comparer<string>.Create((a, b) =>
                a.Length != b.Length ? a.Length.CompareTo(b.Length) : string.CompareOrdinal(a, b)));
            int malformed = 0;
            ulong claimed = 0;
            foreach (object item in hierarchy)
            {
                if (!(item is List<object> pair) || pair.Count < 2 || !(pair[0] is string name) || !JsonReader.IsNumber(pair[1])
                    || !PotreeNames.TryParse(name, MaxLevels, out _, out _)
                    || points.TryGetValue(name, out long before) && before > 0)
                {
                    malformed++;
                    continue;
                }
                double count = JsonReader.ToDouble(pair[1]);
                points[name] = (long)Math.Max(0, Math.Min(uint.MaxValue, count));
                claimed += (ulong)points[name];
                for (string parent = name.Substring(0, name.Length - 1); parent.Length > 0 && !points.ContainsKey(parent);
                    parent = parent.Substring(0, parent.Length - 1))
                    points.Add(parent, 0);
            }
            if (malformed > 0)
                info.Warn(-1,
                    "\"hierarchy\": " + NumberText.Of(malformed) + " entries are no name and count, or come twice: left out");
            if (info.PointsClaimed == 0)
                info.PointsClaimed = claimed;
            var list = new List<(string, long)>();
            foreach (var pair in points)
                list.Add((pair.Key, pair.Value));
            return list;
        }

        // The length of an unknown attribute is the rest of the root's records.
        static void MeasureUnknown(Potree1Metadata metadata, Potree1Files files, List<(string Name, long Points)> listed)
        {
            long bytes = RandomAccessFile.LengthOf(files.PathOf(0, default)), points = 0;
            if (listed != null && listed.Count > 0)
                points = listed[0].Points;
            else if (listed == null)
                using (var source = RandomAccessFile.Open(files.HierarchyPathOf(0, default)))
                    points = source.Read(0, RecordBytes, "the root's record").UInt32(1, "points");
            long others = 0;
            foreach (var attribute in metadata.Attributes)
                others += attribute?.Bytes ?? 0;
            long unknown = points > 0 && bytes > 0 && bytes % points == 0 ? bytes / points - others : 0;
            if (unknown < 1 || unknown > PotreeAttribute.MaxElements)
                throw PointCloudException.Wanted(FailureCode.Unsupported, metadata.Info.Path, -1, "\"pointAttributes\"",
                    "names that are known", metadata.UnknownAttribute);
            int at = metadata.Attributes.IndexOf(null);
            metadata.Attributes[at] = PotreeAttribute.Make(metadata.UnknownAttribute, "uint8", (int)unknown, null, null, out _);
            metadata.Info.Warn(-1, "attribute \"" + metadata.UnknownAttribute + "\" is not known: its " + NumberText.Of(unknown)
                + " bytes are read as they are");
        }
    }
}
