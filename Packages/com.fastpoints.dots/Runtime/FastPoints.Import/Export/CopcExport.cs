using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>COPC 1.0: each node of a converted cloud is a chunk of LAZ, with the tiny leaves that its parent holds, and the
    /// octree's keys lie behind them.</summary>
    internal sealed class CopcExport : LazExport
    {
        /// <summary>Behind the file's name: the temporary cloud that its points are converted to.</summary>
        public const string OctreeSuffix = ".octree";

        const string Extension = ".copc.laz";
        const double DefaultPointsAcross = 128; // Of the root's edge, if the root is all.

        /// <summary>Cubes begin this part of a step before their first points: no point lies on a face, which readers would
        /// round to either side. In binary a third never ends, so points at one place do not meet the faces of cubes that are
        /// smaller than a step either.</summary>
        const double Margin = 1.0 / 3;

        readonly ConvertedReader m_reader;
        readonly GridCube m_root;
        readonly CopcEntry[] m_keyOfBlock;
        readonly List<int> m_blockOfNode = new List<int>();
        readonly List<int> m_bytesOfChunk = new List<int>();
        readonly List<CopcEntry> m_nodes = new List<CopcEntry>();
        int m_written;
        long m_end;
        long m_pagesOffset;
        int m_rootPageBytes;

        /// <exception cref="PointCloudException">More points lie at one place than the levels of COPC hold.</exception>
        public CopcExport(ConvertedReader reader, string[] chosen)
            : base(reader, chosen, reader.PointCount, Math.Max(StoreFormat.MaxPointsPerNode, reader.MaxPointsPerBlock))
        {
            m_reader = reader;
            m_root = reader.Manifest.Root;
            m_keyOfBlock = new CopcEntry[reader.BlockCount];
            HasBufferPerNode = true;
            AddVlr(LasVlr.ToBytes(CopcInfo.UserId, CopcInfo.InfoRecord, "COPC info", new byte[CopcInfo.Bytes]), true);
            // Point formats from 6 on want the bit, unless GeoTIFF keys are all that is known.
            var crs = reader.Info.Crs;
            if (crs.Wkt != null || crs.GeoKeys == null && crs.Epsg == 0 && crs.VerticalEpsg == 0)
                Header.GlobalEncoding |= LasHeader.WktBit;
            FindKeys();
        }

        public static bool IsNamed(string path) => path.EndsWith(Extension, StringComparison.OrdinalIgnoreCase);

        /// <summary>Whether the source is a converted cloud with one grid step for all axes: its cubes are COPC's.</summary>
        public static bool CanExport(PointReader reader) =>
            reader is ConvertedReader stored && math.all(stored.Manifest.Grid.Step == stored.Manifest.Grid.Step.x);

        protected override void ChooseFormat(PointSchema schema, string[] chosen)
        {
            base.ChooseFormat(schema, chosen);
            int format = Header.PointFormat;
            Header.PointFormat = new[] { 6, 6, 7, 7, 6, 7, 6, 7, 8, 6, 8 }[format];
            Header.VersionMinor = 4;
            if (Header.PointFormat != format)
                Note = "point format " + format + " becomes " + Header.PointFormat + ", which COPC wants";
        }

        public override void SetRanges(List<ExportRange> ranges)
        {
            for (int i = 0; i < ranges.Count; i++)
            {
                var range = ranges[i];
                if (i == 0 || ranges[i - 1].Range.Block != range.Range.Block)
                    m_blockOfNode.Add(range.Range.Block);
                range.Node = m_blockOfNode.Count - 1;
                range.IsLastOfNode = i + 1 == ranges.Count || ranges[i + 1].Range.Block != range.Range.Block;
                ranges[i] = range;
            }
        }

        public override void Configure(in ExportRange range, ref MakeRecordsJob job)
        {
            job.FirstRecord = (long)range.Node * BufferPoints;
            job.TimeAt = LasPointFormat.Of(LasPointFormat.FirstExtended).RecordBytes - sizeof(double);
            if (Position.Divisor == 1)
                return;
            var cube = m_reader.NodeOf(range.Range.Block).Cube;
            var corner = cube.Corner - Position.Base;
            var low = new double3(corner.X, corner.Y, corner.Z) - Margin;
            job.MinPosition = math.ceil(low / Position.Divisor);
            job.MaxPosition = math.floor((low + cube.Side) / Position.Divisor);
        }

        public override void OnBufferWritten(int bytes, int points)
        {
            var node = m_keyOfBlock[m_blockOfNode[m_written++]];
            if (points == 0)
                return;
            node.Offset = (ulong)m_end;
            node.ByteSize = bytes;
            node.PointCount = points;
            m_nodes.Add(node);
            m_bytesOfChunk.Add(bytes);
            m_end += bytes;
        }

        public override byte[] Trailer()
        {
            var table = LazChunkTable.ToBytes(m_bytesOfChunk, m_nodes.ConvertAll(node => node.PointCount));
            m_pagesOffset = m_end + table.Length + LasVlr.ExtendedHeaderBytes;
            var pages = CopcPages.ToBytes(m_nodes, m_pagesOffset, out m_rootPageBytes);
            var trailer = new byte[table.Length + LasVlr.ExtendedHeaderBytes + pages.Length];
            table.CopyTo(trailer, 0);
            int at = table.Length;
            LasHeader.PutText(trailer, at + 2, 16, CopcInfo.UserId);
            LasHeader.Put(trailer, at + 18, 2, CopcInfo.HierarchyRecord);
            LasHeader.Put(trailer, at + 20, 8, (ulong)pages.Length);
            LasHeader.PutText(trailer, at + 28, 32, "EPT hierarchy");
            pages.CopyTo(trailer, at + LasVlr.ExtendedHeaderBytes);
            return trailer;
        }

        public override byte[] MakeHeader(string path, in ExportState written, long chunksEnd, long pointsEnd)
        {
            var head = base.MakeHeader(path, written, chunksEnd, pointsEnd);
            if (m_pagesOffset == 0)
            {
                m_end = head.Length;
                return head;
            }
            // The hierarchy is the first EVLR.
            LasHeader.Put(head, LasHeader.At.EvlrOffset, 8, (ulong)(m_pagesOffset - LasVlr.ExtendedHeaderBytes));
            LasHeader.Put(head, LasHeader.At.EvlrCount, 4, 1 + BitConverter.ToUInt32(head, LasHeader.At.EvlrCount));
            var grid = m_reader.Manifest.Grid;
            double half = 0.5 * m_root.Side * grid.Step.x;
            bool hasTimes = written.MinTime <= written.MaxTime;
            var info = new CopcInfo
            {
                Center = grid.ToGeo(m_root.Corner) + half - Margin * grid.Step.x,
                HalfSize = half,
                Spacing = SpacingOf(grid.Step.x),
                RootPageOffset = (ulong)m_pagesOffset,
                RootPageBytes = (ulong)m_rootPageBytes,
                MinGpsTime = hasTimes ? written.MinTime : 0,
                MaxGpsTime = hasTimes ? written.MaxTime : 0,
            };
            info.ToBytes().CopyTo(head, Header.HeaderBytes + LasVlr.HeaderBytes);
            return head;
        }

        double SpacingOf(double step)
        {
            var root = m_reader.BlockCount > 0 ? m_reader.NodeOf(0) : default;
            return step * (root.HasSpacing && root.SideLog2 == m_root.SideLog2 ? 1L << root.CellLog2
                : m_root.Side / DefaultPointsAcross);
        }

        void FindKeys()
        {
            var taken = new HashSet<int4>();
            for (int block = 0; block < m_keyOfBlock.Length; block++)
            {
                var node = m_reader.NodeOf(block);
                int level = m_reader.LevelOf(block), shift = node.BoundsShift;
                var position = node.Corner - m_root.Corner;
                var key = KeyAt(position, level);
                // Nodes that chain more points at one place share a cube: in COPC each gets a smaller one.
                position += new Grid3((long)node.MinX << shift, (long)node.MinY << shift, (long)node.MinZ << shift);
                while (level <= CopcEntry.MaxLevel && !taken.Add(key.Key))
                    key = KeyAt(position, ++level);
                if (level > CopcEntry.MaxLevel)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, m_reader.Info.Path, -1,
                        "levels of the octree, which more points at one place ask for", "at most " + CopcEntry.MaxLevel, level);
                m_keyOfBlock[block] = key;
            }
        }

        CopcEntry KeyAt(Grid3 position, int level)
        {
            int up = m_root.SideLog2 - level;
            int Cell(long steps) => (int)(up >= 0 ? steps >> up : (steps << -up) + (1L << -up) / 3);
            return new CopcEntry { Level = level, Cell = new int3(Cell(position.X), Cell(position.Y), Cell(position.Z)) };
        }
    }

    /// <summary>The hierarchy of COPC: a page for the root, and one for each branch that fits a page while its parent does
    /// not.</summary>
    internal static class CopcPages
    {
        public const int DefaultEntries = 2048; // 64 KiB.
        const int MinEntries = 32; // A branch of fewer nodes is not worth a read.

        /// <summary>All pages, one after another, the root's first.</summary>
        /// <param name="nodes">Those with points; ancestors may be missing.</param>
        /// <param name="at">Where the pages will lie.</param>
        public static byte[] ToBytes(IReadOnlyList<CopcEntry> nodes, long at, out int rootBytes, int maxEntries = DefaultEntries)
        {
            var all = new Dictionary<int4, CopcEntry> { [default] = default };
            foreach (var node in nodes)
                all[node.Key] = node;
            foreach (var node in nodes)
                for (var key = ParentOf(node.Key); key.w >= 0 && !all.ContainsKey(key); key = ParentOf(key))
                    all[key] = new CopcEntry { Level = key.w, Cell = key.xyz };
            var order = new List<int4>(all.Keys);
            order.Sort((a, b) => a.w != b.w ? a.w.CompareTo(b.w) : a.x != b.x ? a.x.CompareTo(b.x)
                : a.y != b.y ? a.y.CompareTo(b.y) : a.z.CompareTo(b.z));
            var sizes = new Dictionary<int4, int>();
            for (int i = order.Count - 1; i >= 0; i--)
            {
                sizes.TryGetValue(order[i], out int below);
                sizes[order[i]] = below + 1;
                if (order[i].w > 0)
                {
                    sizes.TryGetValue(ParentOf(order[i]), out int others);
                    sizes[ParentOf(order[i])] = others + below + 1;
                }
            }

            var pages = new List<List<CopcEntry>> { new List<CopcEntry>() };
            var pageOf = new Dictionary<int4, int>();
            foreach (var key in order)
            {
                int page = key.w == 0 ? 0 : pageOf[ParentOf(key)];
                if (key.w > 0 && page == 0 && sizes[key] <= maxEntries && sizes[key] >= MinEntries &&
                    sizes[ParentOf(key)] > maxEntries)
                {
                    page = pages.Count;
                    pages.Add(new List<CopcEntry>());
                    pages[0].Add(new CopcEntry
                    {
                        Level = key.w,
                        Cell = key.xyz,
                        ByteSize = sizes[key] * CopcEntry.Bytes,
                        PointCount = CopcEntry.PointCountOfPage,
                    });
                }
                pageOf[key] = page;
                pages[page].Add(all[key]);
            }
            rootBytes = pages[0].Count * CopcEntry.Bytes;
            return ToBytes(pages, at + rootBytes, order.Count + pages.Count - 1);
        }

        /// <param name="next">Where the page behind the root's will lie: the root names them in their order.</param>
        static byte[] ToBytes(List<List<CopcEntry>> pages, long next, int entries)
        {
            var bytes = new byte[entries * CopcEntry.Bytes];
            int to = 0;
            foreach (var page in pages)
                foreach (var entry in page)
                {
                    var put = entry;
                    if (put.IsPage)
                    {
                        put.Offset = (ulong)next;
                        next += put.ByteSize;
                    }
                    put.Put(bytes, to);
                    to += CopcEntry.Bytes;
                }
            return bytes;
        }

        static int4 ParentOf(int4 key) => new int4(key.x >> 1, key.y >> 1, key.z >> 1, key.w - 1);
    }
}
