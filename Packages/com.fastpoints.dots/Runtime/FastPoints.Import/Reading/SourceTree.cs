using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    // The octree that a source contains (COPC, Potree, EPT), as far as its hierarchy has been read: additive levels, each node's
    // points in a block of their own. Nodes are only ever added, a parent before its children, so indices stay valid while pages
    // are read. A node takes 24 bytes.
    internal sealed class SourceTree : IDisposable
    {
        NativeList<SourceNode> m_nodes;

        // cube: the root's, CRS units; spacing: between points of the root, CRS units; it halves from level to level.
        public SourceTree(BoundsGeo cube, double spacing, Allocator allocator)
        {
            Cube = cube;
            Spacing = spacing;
            m_nodes = new NativeList<SourceNode>(64, allocator);
        }

        public BoundsGeo Cube { get; }
        public double Spacing { get; }
        public int NodeCount => m_nodes.Length;
        public int LevelCount { get; private set; }
        public int PageCount { get; set; }

        public bool IsHierarchyRead { get; set; } // All pages were read, or abandoned with a warning.

        public SourceNode this[int node] => m_nodes[node];

        // For jobs: no node may be added before these have ended.
        public NativeArray<SourceNode> AsArray() => m_nodes.AsArray();

        public void Add(SourceNode node)
        {
            m_nodes.Add(node);
            LevelCount = Math.Max(LevelCount, node.Level + 1);
        }

        /// <summary>Edge of a level's nodes, CRS units.</summary>
        public double EdgeOfLevel(int level) => Cube.Size.x / Math.Pow(2, level);

        public void Dispose()
        {
            if (m_nodes.IsCreated)
                m_nodes.Dispose();
        }
    }

    // A node with more points than a block exists several times, once for each block.
    internal struct SourceNode
    {
        public int Level;
        public int3 Cell;
        public int Block; // -1 for a node without points.

        public int PointCount;

        public int4 Key => new int4(Cell, Level);
    }

    // The hierarchy of the octree is read page by page; IndexBlocks reads all of it.
    internal interface IOctreeSource
    {
        // Coroutine: the pages that the first levels, counted from the root, need for a node and what is below it; afterwards
        // their blocks can be read although BlocksAreKnown is false. Never opens or reads a file on the main thread.
        IEnumerator<JobStep> ReadHierarchyBelow(int4 node, int levels);

        // ReadHierarchyBelow has nothing to read.
        bool IsKnownBelow(int4 node, int levels);
    }

    internal static class OctreeSources
    {
        public static IEnumerator<JobStep> ReadLevels(this PointReader reader, int levels) =>
            reader.ReadHierarchyBelow(default, levels);

        public static IEnumerator<JobStep> ReadHierarchyBelow(this PointReader reader, int4 node, int levels) =>
            reader is IOctreeSource octree ? octree.ReadHierarchyBelow(node, levels) : reader.IndexBlocks();

        public static bool IsKnownBelow(this PointReader reader, int4 node, int levels) =>
            reader is IOctreeSource octree ? octree.IsKnownBelow(node, levels) : reader.BlocksAreKnown;
    }

    // Known pages of an octree's hierarchy, by the level of the nodes that they begin with, in the order of discovery.
    internal sealed class UnreadPages
    {
        readonly Queue<UnreadPage>[] m_ofLevel;

        // Pages that were read out of turn and are still in the queues.
        readonly HashSet<int> m_isRead = new HashSet<int>();
        int m_added;

        public UnreadPages(int maxLevels)
        {
            m_ofLevel = new Queue<UnreadPage>[maxLevels];
            for (int level = 0; level < maxLevels; level++)
                m_ofLevel[level] = new Queue<UnreadPage>();
        }

        public int Count { get; private set; }

        public void Add(int4 root, long offset = 0, long bytes = 0)
        {
            var page = new UnreadPage { Root = root, Offset = offset, Bytes = bytes, Number = m_added++ };
            m_ofLevel[root.w].Enqueue(page);
            Count++;
        }

        // The next page that a node (the root: all pages, at no cost), those above and those below it need; pages that begin
        // below "levels" are ignored.
        public bool TryPeek(int4 node, int levels, out UnreadPage page)
        {
            for (int level = 0; level < math.min(levels, m_ofLevel.Length); level++)
            {
                var pages = m_ofLevel[level];
                while (pages.Count > 0 && m_isRead.Remove(pages.Peek().Number))
                    pages.Dequeue();
                foreach (var waiting in pages)
                {
                    page = waiting;
                    if (IsOnSameBranch(waiting.Root, node) && !m_isRead.Contains(waiting.Number))
                        return true;
                }
            }
            page = default;
            return false;
        }

        public void Remove(in UnreadPage page)
        {
            m_isRead.Add(page.Number);
            Count--;
        }

        public void Clear()
        {
            foreach (var pages in m_ofLevel)
                pages.Clear();
            m_isRead.Clear();
            Count = 0;
        }

        // Whether they are equal, or one contains the other.
        static bool IsOnSameBranch(int4 a, int4 b)
        {
            int level = math.min(a.w, b.w);
            return math.all(a.xyz >> (a.w - level) == b.xyz >> (b.w - level));
        }
    }

    internal struct UnreadPage
    {
        public int4 Root;

        // 0 if it is a file of its own.
        public long Offset;
        public long Bytes;
        public int Number;
    }
}
