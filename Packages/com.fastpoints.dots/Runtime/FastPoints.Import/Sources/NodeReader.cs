using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Blocks are nodes of an octree, in separate files or in one. A node with more points than a slot should hold
    // becomes several blocks; the tree then has an entry for each, with the same cell.
    internal abstract class NodeReader : PointReader, IOctreeSource
    {
        internal const long UnknownBytes = -2; // Of a remote file whose length only reading it tells.

        const int GuessedBytesPerPoint = 8;

        readonly List<NodeBlock> m_blocks = new List<NodeBlock>();
        readonly HashSet<int> m_reportedBlocks = new HashSet<int>();
        readonly Dictionary<int4, long> m_endOfNode = new Dictionary<int4, long>();
        int m_maxPointsPerBlock;

        private protected NodeReader(SourceInfo info, BoundsGeo cube, double spacing)
        {
            Info = info;
            Warnings = new NodeWarnings(info);
            Tree = new SourceTree(cube, spacing, Allocator.Persistent);
        }

        internal sealed override SourceTree Tree { get; }

        public sealed override bool BlocksAreKnown => Tree.IsHierarchyRead;
        public sealed override int BlockCount => m_blocks.Count;
        public sealed override int MaxPointsPerBlock => m_maxPointsPerBlock;

        internal NodeWarnings Warnings { get; }

        public sealed override long FirstPointOfBlock(int block) => Block(block).FirstPoint;

        public sealed override int PointsInBlock(int block) => Block(block).Points;

        // max: points of a block; bytes: of all points of the node; bytesPerPoint: 0 if a block needs all of these bytes.
        internal void AddNode(SourceNode node, long points, long max, long offset, long bytes, int bytesPerPoint)
        {
            node.Block = -1;
            if (points <= 0)
                Tree.Add(node);
            for (long first = 0; first < points; first += max)
            {
                int count = (int)Math.Min(max, points - first);
                node.Block = m_blocks.Count;
                node.PointCount = count;
                m_blocks.Add(new NodeBlock
                {
                    Node = Tree.NodeCount,
                    FirstPoint = PointCount,
                    FirstInNode = first,
                    Points = count,
                    NodePoints = points,
                    Offset = offset + first * bytesPerPoint,
                    Bytes = bytesPerPoint > 0 ? (long)count * bytesPerPoint : bytes,
                });
                Tree.Add(node);
                m_maxPointsPerBlock = Math.Max(m_maxPointsPerBlock, count);
            }
        }

        internal NodeBlock Block(int block) => (uint)block < (uint)m_blocks.Count ? m_blocks[block]
            : throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + m_blocks.Count + " blocks");

        // An estimate before a remote file is read whole.
        internal static long BytesOf(in NodeBlock block) =>
            block.Bytes < 0 ? block.NodePoints * GuessedBytesPerPoint : block.Bytes;

        internal SourceNode NodeOf(int block) => Tree[m_blocks[block].Node];

        public abstract IEnumerator<JobStep> ReadHierarchyBelow(int4 node, int levels);

        public abstract bool IsKnownBelow(int4 node, int levels);

        internal abstract string NameOf(int level, int3 cell);

        private protected abstract int BytesPerPoint { get; } // Of a record in the file; 0 if a node is read whole.

        // What a range is decoded from; of negative length for a whole remote file, however long it is.
        internal FilePiece PieceOf(BlockRange range)
        {
            var block = Block(range.Block);
            int bytesPerPoint = BytesPerPoint;
            return new FilePiece
            {
                Path = FileOfBlock(range.Block, out _),
                OffsetBytes = block.Offset + (long)range.First * bytesPerPoint,
                LengthBytes = bytesPerPoint > 0 ? (long)range.Count * bytesPerPoint : block.Bytes,
            };
        }

        internal sealed override void ListPieces(BlockRange range, List<FilePiece> pieces) => pieces.Add(PieceOf(range));

        internal virtual JobHandle BeginRead(NativeFileRead read, in FilePiece piece) =>
            read.Begin(piece.Path, piece.OffsetBytes, (int)piece.LengthBytes);

        // Later blocks are not tried once a node has given its last point: each would decode the node from its start.
        internal void MarkEndOfNode(int block, long point) =>
            m_endOfNode[NodeOf(block).Key] = Math.Min(point, EndOfNode(block));

        internal long EndOfNode(int block) =>
            m_endOfNode.TryGetValue(NodeOf(block).Key, out long end) ? end : Block(block).NodePoints;

        // Once a block: it gave fewer points than it has.
        internal void WarnBroken(int block, string kind, string detail, long byteOffset)
        {
            var node = NodeOf(block);
            if (m_reportedBlocks.Add(block))
                Warnings.Add(kind, NameOf(node.Level, node.Cell), detail, byteOffset, FileOfBlock(block, out _));
        }

        public sealed override void DisposeUnread() => Tree.Dispose();
    }

    struct NodeBlock
    {
        public int Node;
        public long FirstPoint;
        public long FirstInNode;
        public int Points;
        public long NodePoints;
        public long Offset;
        public long Bytes; // Or NodeReader.UnknownBytes.
    }

    // The first few anomalies of a kind are reported one by one, the others as a count.
    sealed class NodeWarnings
    {
        const int MaxReported = 3;

        sealed class Kind
        {
            public int Count;
            public int Warning = -1;
        }

        readonly SourceInfo m_info;
        readonly Dictionary<string, Kind> m_kinds = new Dictionary<string, Kind>();

        public NodeWarnings(SourceInfo info) => m_info = info;

        // what: the same text for all nodes; path: null for the source's own.
        public void Add(string what, string node, string detail = null, long byteOffset = -1, string path = null)
        {
            if (!m_kinds.TryGetValue(what, out var kind))
                m_kinds.Add(what, kind = new Kind());
            kind.Count++;
            if (kind.Count <= MaxReported)
            {
                m_info.Warnings.Add(new CloudWarning(path ?? m_info.Path, byteOffset,
                    "node " + node + ": " + what + (detail != null ? ": " + detail : "")));
                return;
            }
            var others = new CloudWarning(m_info.Path, -1, NumberText.Of(kind.Count - MaxReported) + " more nodes: " + what);
            if (kind.Warning < 0)
            {
                kind.Warning = m_info.Warnings.Count;
                m_info.Warnings.Add(others);
            }
            m_info.Warnings[kind.Warning] = others;
        }
    }
}
