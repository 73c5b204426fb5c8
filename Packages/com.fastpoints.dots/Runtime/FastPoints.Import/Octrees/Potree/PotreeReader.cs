using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // The octrees of PotreeConverter, 1.4 to 1.8 and 2.x. A node with more points than a slot should hold becomes several blocks
    // if its records allow it; the tree then has an entry for each, with the same cell. A hierarchy's claims are checked against
    // the existing files: missing or short ones are holes with warnings. Each byte of a hierarchy is used only once, so that
    // loops end.
    internal abstract class PotreeReader : PointReader
    {
        // Cells of deeper levels do not fit 32-bit coordinates; converters stop far above.
        internal const int MaxLevels = 30;

        // More than the largest clouds have: it bounds the memory of a hierarchy.
        internal const int MaxNodes = 1 << 21;

        // Of a block that can be cut.
        internal const int MaxBlockPoints = 1 << 20;

        // Of a node that cannot be cut.
        internal const int MaxNodePoints = 1 << 22;

        // In the columns of a node that cannot be cut: it bounds a slot, whatever a file claims.
        internal const int MaxNodeBytes = 1 << 27;

        // In the records of a block that can be cut.
        const int MaxBlockBytes = 1 << 26;

        readonly List<PotreeBlock> m_blocks = new List<PotreeBlock>();
        readonly HashSet<int> m_reportedBlocks = new HashSet<int>();
        readonly SourceTree m_tree;
        long m_pointCount;
        int m_maxPointsPerBlock;

        private protected PotreeReader(SourceInfo info, BoundsGeo cube, double spacing)
        {
            Info = info;
            Warnings = new PotreeWarnings(info);
            m_tree = new SourceTree(cube, spacing, Allocator.Persistent);
        }

        internal override SourceTree Tree => m_tree;

        public override bool BlocksAreKnown => m_tree.IsWhole;

        public override int BlockCount => m_blocks.Count;

        public override int MaxPointsPerBlock => m_maxPointsPerBlock;

        private protected PotreeWarnings Warnings { get; }

        // According to the hierarchy, as far as it has been read.
        private protected long PointsClaimed { get; set; }

        public override long FirstPointOfBlock(int block) => Block(block).FirstPoint;

        public override int PointsInBlock(int block) => Block(block).Points;

        public override long BytesOfRange(BlockRange range)
        {
            var block = Block(range.Block);
            return HasFixedStride
                ? (long)(block.Bytes * (range.Count / (double)Math.Max(1, block.Points)))
                : (long)(block.Bytes * ((range.First + range.Count) / (double)Math.Max(1, block.Points)));
        }

        private protected UnreadPages Pages { get; } = new UnreadPages(MaxLevels + 1);

        public override IEnumerator<JobStep> FindBlocks() => FindLevels(MaxLevels + 1);

        public override IEnumerator<JobStep> FindBelow(int4 node, int levels)
        {
            if (!m_tree.IsWhole)
                yield return JobStep.Of(ReadPages(node, levels));
            if (!m_tree.IsWhole)
                yield break;
            Info.PointsReadable = m_pointCount;
            if (Info.PointsClaimed == 0)
                Info.PointsClaimed = (ulong)PointsClaimed;
        }

        // Coroutine, which can be abandoned and begun again for another node: reads the parts of the hierarchy that the first
        // levels need for a node and what is below it. Steps take some milliseconds at most.
        private protected abstract IEnumerator<JobStep> ReadPages(int4 node, int levels);

        // bytes: of all its points in the file; bytesPerPoint: if fixed, so that a long node can be cut; otherwise 0.
        private protected void AddNode(int level, int3 cell, long points, long offset, long bytes, int bytesPerPoint)
        {
            var node = new SourceNode { Level = level, Cell = cell, Block = -1 };
            if (points <= 0)
            {
                m_tree.Add(node);
                return;
            }
            long max = bytesPerPoint > 0 ? Math.Min(MaxBlockPoints, MaxBlockBytes / bytesPerPoint) : points;
            for (long first = 0; first < points; first += max)
            {
                int count = (int)Math.Min(max, points - first);
                node.Block = m_blocks.Count;
                node.PointCount = count;
                m_blocks.Add(new PotreeBlock
                {
                    Node = m_tree.NodeCount,
                    FirstPoint = m_pointCount,
                    Points = count,
                    Offset = offset + first * bytesPerPoint,
                    Bytes = bytesPerPoint > 0 ? (long)count * bytesPerPoint : bytes,
                });
                m_tree.Add(node);
                m_pointCount += count;
                m_maxPointsPerBlock = Math.Max(m_maxPointsPerBlock, count);
            }
        }

        private protected bool IsFull(long next)
        {
            if (m_tree.NodeCount < MaxNodes)
                return false;
            Info.Warn(next, "the hierarchy has more than " + NumberText.Of(MaxNodes) + " nodes: the others are left out");
            return true;
        }

        internal PotreeBlock Block(int block)
        {
            if ((uint)block >= (uint)m_blocks.Count)
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + m_blocks.Count + " blocks");
            return m_blocks[block];
        }

        internal SourceNode NodeOf(int block) => m_tree[m_blocks[block].Node];

        internal string NameOf(int block)
        {
            var node = NodeOf(block);
            return PotreeNames.NameOf(node.Level, node.Cell);
        }

        internal long MaxBytesPerBlock()
        {
            long max = 0;
            foreach (var block in m_blocks)
                max = Math.Max(max, block.Bytes);
            return max;
        }

        // Once a block.
        internal void WarnBroken(int block, string kind, string detail, long byteOffset)
        {
            if (m_reportedBlocks.Add(block))
                Warnings.Add(kind, NameOf(block), detail, byteOffset, FileOfBlock(block, out _));
        }

        public override void DisposeUnread() => m_tree.Dispose();
    }

    struct PotreeBlock
    {
        public int Node;
        public long FirstPoint;

        public int Points;

        // In the file that holds it.
        public long Offset;

        public long Bytes;
    }
}
