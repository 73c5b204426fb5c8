using System;
using FastPoints.Scenes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>The hierarchy of a surface scan that nobody has to store: squares of a hilly plane, each with four below it, a
    /// twentieth of the finest with four more. Nine levels and up have 100,000 nodes with 10,000 points each: a billion points.
    /// The upper four levels are page 0, the squares of the fifth and all below are a page each.</summary>
    public sealed unsafe class SimulatedHierarchy : IDisposable
    {
        public const int UpperLevels = 4;
        public const int PointsPerNode = 10_000;
        public const double SideLocal = 8192;
        const int PointsAcrossNode = 100;

        NativeArray<HierarchyPage> m_pages;

        public SimulatedHierarchy(int levels, double3 stretch)
        {
            int across = 1 << UpperLevels;
            m_pages = new NativeArray<HierarchyPage>(1 + across * across, Allocator.Persistent);
            for (int chunk = 0; chunk < across * across; chunk++)
                m_pages[1 + chunk] = Build(UpperLevels, PositionOf(chunk, UpperLevels), levels - UpperLevels, true, -1, stretch);
            m_pages[0] = Build(0, default, UpperLevels, false, 0, stretch);
            for (int p = 0; p < m_pages.Length; p++)
                NodeCount += m_pages[p].NodeCount;
        }

        public HierarchyPage* Pages => (HierarchyPage*)m_pages.GetUnsafePtr();
        public int PageCount => m_pages.Length;
        public int NodeCount { get; }

        public void Dispose()
        {
            if (!m_pages.IsCreated)
                return;
            for (int p = 0; p < m_pages.Length; p++)
            {
                var page = m_pages[p];
                page.Free();
            }
            m_pages.Dispose();
        }

        public static double HeightAt(double x, double y) =>
            200 * math.sin(x * 0.0013) * math.cos(y * 0.0017) + 15 * math.sin(x * 0.021 + y * 0.013);

        /// <summary>The i-th square of a level along the Morton curve.</summary>
        static int2 PositionOf(int index, int level)
        {
            var position = new int2(0, 0);
            for (int bit = 0; bit < level; bit++)
                position += new int2(index >> (2 * bit) & 1, index >> (2 * bit + 1) & 1) << bit;
            return position;
        }

        static HierarchyPage Build(int topLevel, int2 top, int levels, bool hasDenseParts, int firstChunk, double3 stretch)
        {
            int full = 0, last = 1 << (2 * (levels - 1));
            for (int level = 0; level < levels; level++)
                full += 1 << (2 * level);
            int dense = 0;
            for (int i = 0; i < last; i++)
                dense += hasDenseParts && IsDense(topLevel, top, i) ? 1 : 0;
            var page = new HierarchyPage();
            page.Allocate(full + 4 * dense, 0);
            page.RootCount = 1;
            page.Status = HierarchyPageStatus.Loaded;
            int at = 0, nextDense = full;
            for (int level = 0; level < levels; level++)
            {
                int begin = at, count = 1 << (2 * level);
                for (int i = 0; i < count; i++, at++)
                {
                    var position = (top << level) + PositionOf(i, level);
                    var node = NodeAt(topLevel + level, position, stretch);
                    if (level + 1 < levels)
                    {
                        node.FirstChild = begin + count + 4 * i;
                        node.ChildCount = 4;
                    }
                    else if (firstChunk >= 0)
                    {
                        node.FirstPage = 1 + firstChunk + 4 * i;
                        node.PageCount = 4;
                    }
                    else if (hasDenseParts && IsDense(topLevel, top, i))
                    {
                        node.FirstChild = nextDense;
                        node.ChildCount = 4;
                        for (int c = 0; c < 4; c++)
                            page.Nodes[nextDense++] = NodeAt(topLevel + level + 1, (position << 1) + PositionOf(c, 1), stretch);
                    }
                    page.Nodes[at] = node;
                }
            }
            for (int n = 0; n < page.NodeCount; n++)
                page.States[n] = new NodeState { Slot = NodeState.NoSlot };
            page.Center = page.Nodes[0].Center;
            page.Half = page.Nodes[0].Half;
            return page;
        }

        static bool IsDense(int level, int2 top, int index) =>
            SceneHash.Of((uint)top.x << level, (uint)top.y, (uint)index) % 20 == 0;

        static StreamNode NodeAt(int level, int2 position, double3 stretch)
        {
            double side = SideLocal / (1 << level);
            double x = position.x * side, y = position.y * side, low = double.MaxValue, high = double.MinValue;
            const int Steps = 8;
            for (int i = 0; i <= Steps * Steps + 2 * Steps; i++)
            {
                double height = HeightAt(x + side * (i % (Steps + 1)) / Steps, y + side * (i / (Steps + 1)) / Steps);
                low = math.min(low, height);
                high = math.max(high, height);
            }
            return new StreamNode
            {
                Center = new double3(x + side / 2, y + side / 2, (low + high) / 2) * stretch,
                Half = (float3)(new double3(side / 2, side / 2, (high - low) / 2) * stretch),
                Spacing = (float)(side / PointsAcrossNode * math.cmax(stretch)),
                PointCount = PointsPerNode,
                BlockCount = (PointsPerNode + 127) / 128,
            };
        }
    }
}
