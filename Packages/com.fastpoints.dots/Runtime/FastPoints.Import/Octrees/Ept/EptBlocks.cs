using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    sealed class EptBlocks
    {
        public const string DataFolder = "ept-data";
        const int MaxBlockPoints = 1 << 20;
        const int MaxBlockBytes = 32 << 20;

        readonly EptIndex m_index;
        readonly List<EptBlock> m_blocks = new List<EptBlock>();
        readonly HashSet<int> m_reportedBlocks = new HashSet<int>();
        readonly Dictionary<(int, int3), long> m_endOfNode = new Dictionary<(int, int3), long>();
        readonly int m_blockPoints;

        public EptBlocks(EptIndex index, int pointBytes)
        {
            m_index = index;
            m_blockPoints = Math.Max(1, Math.Min(MaxBlockPoints, MaxBlockBytes / pointBytes));
            Warnings = new PotreeWarnings(index.Info);
            Tree = new SourceTree(index.Cube, index.Spacing, Allocator.Persistent);
        }

        public SourceTree Tree { get; }

        public PotreeWarnings Warnings { get; }

        public int Count => m_blocks.Count;

        public long PointCount { get; private set; }

        public int MaxPoints { get; private set; }

        public EptBlock this[int block] => (uint)block < (uint)m_blocks.Count ? m_blocks[block]
            : throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + m_blocks.Count + " blocks");

        // points: how many can be read.
        public void Add(EptEntry entry, long points, long fileBytes)
        {
            var node = new SourceNode { Level = entry.Level, Cell = entry.Cell, Block = -1 };
            if (points == 0)
                Tree.Add(node);
            for (long first = 0; first < points; first += m_blockPoints)
            {
                int count = (int)Math.Min(m_blockPoints, points - first);
                node.Block = m_blocks.Count;
                node.PointCount = count;
                m_blocks.Add(new EptBlock
                {
                    Level = entry.Level,
                    Cell = entry.Cell,
                    FirstPoint = PointCount,
                    FirstInNode = first,
                    Points = count,
                    NodePoints = points,
                    FileBytes = fileBytes,
                });
                Tree.Add(node);
                PointCount += count;
                MaxPoints = Math.Max(MaxPoints, count);
            }
        }

        // Later blocks are not tried once a node has given its last point: each would decode the node from its start.
        public void EndNode(in EptBlock block, long point)
        {
            var node = (block.Level, block.Cell);
            m_endOfNode[node] = Math.Min(point, EndOfNode(block));
        }

        // As far as is known.
        public long EndOfNode(in EptBlock block) =>
            m_endOfNode.TryGetValue((block.Level, block.Cell), out long end) ? end : block.NodePoints;

        public string PathOf(in EptBlock block) => PathOf(block.Level, block.Cell);

        public string PathOf(int level, int3 cell)
        {
            string ending = m_index.DataType == EptDataType.Binary ? ".bin"
                : m_index.DataType == EptDataType.Laszip ? ".laz" : ".zst";
            return Path.Combine(m_index.Folder, DataFolder, EptEntry.NameOf(level, cell) + ending);
        }

        // Once for each block.
        public void WarnBroken(int block, string what, string detail, long byteOffset)
        {
            var of = this[block];
            if (m_reportedBlocks.Add(block))
                Warnings.Add(what, EptEntry.NameOf(of.Level, of.Cell), detail, byteOffset, PathOf(of));
        }
    }

    struct EptBlock
    {
        public int Level;
        public int3 Cell;
        public long FirstPoint;
        public long FirstInNode;

        public int Points;
        public long NodePoints;

        public long FileBytes;
    }
}
