using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>Reads Entwine Point Tiles (EPT 0.0.0 and 1.x): ept.json, pages of a hierarchy, and a file a node: plain records,
    /// zstandard or LAZ. Blocks are nodes, known as far as pages of the hierarchy have been read.</summary>
    /// <remarks>A node's file is opened for its range and closed behind it. A node with more points than a slot should hold
    /// becomes several blocks; if it is compressed, each block decodes its file from the start.</remarks>
    internal sealed class EptReader : PointReader
    {
        const string DataFolder = "ept-data";
        const int MaxBlockPoints = 1 << 20;
        const int MaxBlockBytes = 32 << 20;

        readonly EptIndex m_index;
        readonly SourceTree m_tree;
        readonly EptHierarchy m_hierarchy;
        readonly List<EptBlock> m_blocks = new List<EptBlock>();
        readonly HashSet<int> m_toldBlocks = new HashSet<int>();
        readonly Dictionary<(int, int3), long> m_endOfNode = new Dictionary<(int, int3), long>();
        readonly int m_blockPoints;
        long m_pointCount;
        int m_maxPointsPerBlock;

        EptReader(EptIndex index, LasFile las, LazFormat laz)
        {
            m_index = index;
            Info = index.Info;
            Las = las;
            Laz = laz;
            int pointBytes = Math.Max(Info.Schema.BytesPerPoint, las?.Header.RecordBytes ?? index.RecordBytes);
            m_blockPoints = Math.Max(1, Math.Min(MaxBlockPoints, MaxBlockBytes / pointBytes));
            Statistics = new PotreeWarnings(Info);
            m_tree = new SourceTree(index.Cube, index.Spacing, Allocator.Persistent);
            m_hierarchy = new EptHierarchy(this, index, m_tree);
        }

        /// <summary>Reads ept.json and, if nodes are LAZ, the header of one.</summary>
        /// <exception cref="PointCloudException">The index is invalid or names unknown data, or no node's LAZ file can be
        /// read.</exception>
        internal static EptReader Open(JsonMembers json)
        {
            var index = EptIndex.Read(json);
            if (index.DataType != EptDataType.Laszip)
                return new EptReader(index, null, null);
            // Nodes have a scale and offset of their own, which count even if ept.json gives others.
            using (var source = FileSource.Open(AnyNode(index)))
            {
                var las = LasFile.Read(source);
                if (!las.Header.IsCompressed)
                    throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, LasHeader.At.PointFormat,
                        "a node of an EPT of data type laszip", "LAZ", "LAS");
                var format = LazFormat.Read(las);
                if (format.Compressor == LazCompressor.None)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, LasHeader.At.PointFormat,
                        "LASzip compressor", "1 to 3", 0);
                index.Info.Schema = las.Info.Schema;
                index.Info.Transform = las.Info.Transform;
                index.Info.PointFormat = las.Header.PointFormat;
                if (!index.Info.Crs.IsKnown)
                    index.Info.Crs = las.Info.Crs;
                format.AddFacts(index.Info);
                return new EptReader(index, las, format);
            }
        }

        /// <summary>The root's file, or another one if it is missing.</summary>
        static string AnyNode(EptIndex index)
        {
            string folder = Path.Combine(index.Folder, DataFolder);
            string root = Path.Combine(folder, "0-0-0-0.laz");
            if (File.Exists(root) || !Directory.Exists(folder))
                return root;
            foreach (string path in Directory.EnumerateFiles(folder, "*.laz"))
                return path;
            return root;
        }

        internal override SourceTree Tree => m_tree;

        public override bool BlocksAreKnown => m_tree.IsWhole;

        public override int BlockCount => m_blocks.Count;

        public override int MaxPointsPerBlock => m_maxPointsPerBlock;

        public override bool HasFixedStride => m_index.DataType == EptDataType.Binary;

        internal EptIndex Index => m_index;

        /// <summary>The LAS header of the nodes, if they are LAZ; otherwise null.</summary>
        internal LasFile Las { get; }
        internal LazFormat Laz { get; }

        internal PotreeWarnings Statistics { get; }

        public override long FirstPointOfBlock(int block) => Block(block).FirstPoint;

        public override int PointsInBlock(int block) => Block(block).Points;

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = 0;
            return PathOf(Block(block).Level, Block(block).Cell);
        }

        public override long BytesOfRange(BlockRange range)
        {
            var block = Block(range.Block);
            double share = HasFixedStride ? range.Count : m_index.DataType == EptDataType.Laszip ? block.NodePoints
                : block.FirstInNode + range.First + range.Count;
            return (long)(block.FileBytes * Math.Min(1, share / block.NodePoints));
        }

        public override IEnumerator<Work> FindBelow(int4 node, int levels) => m_hierarchy.Read(node, Math.Max(1, levels));

        public override bool IsKnownBelow(int4 node, int levels) => m_tree.IsWhole || m_hierarchy.IsKnown(node, levels);

        public override IEnumerator<Work> FindBlocks()
        {
            if (m_tree.IsWhole)
                yield break;
            yield return Work.Of(m_hierarchy.Read(default, int.MaxValue));
            string found = "ept.json claims " + NumberText.Of(Info.PointsClaimed)
                + " points, the nodes that are there hold " + NumberText.Of(m_pointCount);
            if (m_pointCount == 0 && Info.PointsClaimed > 0)
                throw new PointCloudException(FailureCode.Truncated, Info.Path, -1, found);
            if ((ulong)m_pointCount != Info.PointsClaimed)
                Info.Warn(-1, found);
            Info.PointsReadable = m_pointCount;
            m_tree.IsWhole = true;
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            switch (m_index.DataType)
            {
                case EptDataType.Laszip:
                    return new EptLazRead(this, wanted, capacity, allocator);
                case EptDataType.Zstandard:
                    if (Decompressors.Zstandard == null)
                        throw new PointCloudException(FailureCode.Unsupported, Info.Path, -1, "its points are compressed by "
                            + "zstandard, for which .NET Standard 2.1 has nothing: set Decompressors.Zstandard to a decompressor "
                            + "(the command line takes the system's libzstd), or convert it (./fastpoints convert, or pdal "
                            + "translate to LAZ)");
                    return new EptZstandardRead(this, wanted, capacity, allocator);
                default:
                    return new EptRecordRead(this, wanted, capacity, allocator);
            }
        }

        /// <summary>Adds a node and its blocks.</summary>
        /// <param name="points">Number of points that can be read.</param>
        internal void AddNode(EptEntry entry, long points, long fileBytes)
        {
            var node = new SourceNode { Level = entry.Level, Cell = entry.Cell, Block = -1 };
            if (points == 0)
                m_tree.Add(node);
            for (long first = 0; first < points; first += m_blockPoints)
            {
                int count = (int)Math.Min(m_blockPoints, points - first);
                node.Block = m_blocks.Count;
                node.PointCount = count;
                m_blocks.Add(new EptBlock
                {
                    Level = entry.Level,
                    Cell = entry.Cell,
                    FirstPoint = m_pointCount,
                    FirstInNode = first,
                    Points = count,
                    NodePoints = points,
                    FileBytes = fileBytes,
                });
                m_tree.Add(node);
                m_pointCount += count;
                m_maxPointsPerBlock = Math.Max(m_maxPointsPerBlock, count);
            }
        }

        internal EptBlock Block(int block)
        {
            if ((uint)block >= (uint)m_blocks.Count)
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + m_blocks.Count + " blocks");
            return m_blocks[block];
        }

        /// <summary>
        /// Records that a node gave its last point before <paramref name="point"/>: later blocks are not tried, since each
        /// would decode the node from its start.
        /// </summary>
        internal void EndNode(in EptBlock block, long point)
        {
            var node = (block.Level, block.Cell);
            m_endOfNode[node] = Math.Min(point, EndOfNode(block));
        }

        /// <summary>The most points that a node can have, as far as is known.</summary>
        internal long EndOfNode(in EptBlock block) =>
            m_endOfNode.TryGetValue((block.Level, block.Cell), out long end) ? end : block.NodePoints;

        internal string PathOf(int level, int3 cell)
        {
            string ending = m_index.DataType == EptDataType.Binary ? ".bin"
                : m_index.DataType == EptDataType.Laszip ? ".laz" : ".zst";
            return Path.Combine(m_index.Folder, DataFolder, EptEntry.NameOf(level, cell) + ending);
        }

        /// <summary>Warns about a block that gave fewer points than it has, once for each block.</summary>
        internal void WarnBroken(int block, string what, string detail, long byteOffset)
        {
            var of = Block(block);
            if (m_toldBlocks.Add(block))
                Statistics.Add(what, EptEntry.NameOf(of.Level, of.Cell), detail, byteOffset, PathOf(of.Level, of.Cell));
        }

        public override void DisposeUnread()
        {
            m_tree.Dispose();
        }
    }

    /// <summary>A block of an EPT octree: a node's file, or some of the points in it.</summary>
    struct EptBlock
    {
        public int Level;
        public int3 Cell;

        /// <summary>Index of the first point in the whole source.</summary>
        public long FirstPoint;

        /// <summary>Index of the first point in the file.</summary>
        public long FirstInNode;

        public int Points;

        /// <summary>Points of the node, as the hierarchy claims.</summary>
        public long NodePoints;

        public long FileBytes;
    }
}
