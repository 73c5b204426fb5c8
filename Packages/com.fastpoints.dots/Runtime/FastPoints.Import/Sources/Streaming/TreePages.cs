using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // The hierarchy as pages of some levels each. It reads only the unknown parts that a requested page needs: showing one
    // corner costs what lies there. Main thread; never waits.
    sealed class TreePages : IDisposable
    {
        public const int LevelsPerPage = 4; // At most some hundred nodes if points lie on surfaces.

        // Read before the first page is built: its own, and one more to know whether there are others.
        public const int LevelsToKnow = LevelsPerPage + 1;

        const int Unnumbered = -1;
        const int None = -1;

        readonly PointReader m_reader;
        readonly TreeGrid m_grid;
        readonly List<int4> m_rootOfPage = new List<int4> { default };
        readonly List<int> m_firstAttachedOfPage = new List<int> { Unnumbered };
        readonly List<bool> m_isPageKnown = new List<bool> { true };
        NativeParallelHashMap<int4, int> m_nodeOfKey;
        CoroutineStack m_reading;
        JobHandle m_building;
        int m_nodes;
        bool m_isBroken; // After a failure, no more of the hierarchy is read.

        // The first page that was requested since the last update, and the one being read; or None.
        int m_requestedPage = None;
        int m_pageInFlight = None;

        public TreePages(PointReader reader, TreeGrid grid)
        {
            m_reader = reader;
            m_grid = grid;
            m_nodeOfKey = new NativeParallelHashMap<int4, int>(Math.Max(64, reader.Tree.NodeCount), Allocator.Persistent);
            MapNewNodes();
            if (m_nodeOfKey.ContainsKey(default))
                return;
            Dispose();
            throw new PointCloudException(FailureCode.BadInput, reader.Info.Path, -1, "its octree has no root");
        }

        public int Count => m_rootOfPage.Count;
        public JobHandle Step { get; private set; }
        public bool IsReading => m_reading != null || m_requestedPage != None;

        // The page's levels, and the one below, are known. The first requested page that is not is read next.
        public bool RequestPage(int page)
        {
            if (!m_isPageKnown[page] && m_requestedPage == None)
                m_requestedPage = page;
            return m_isPageKnown[page];
        }

        // Goes on with reading. Returns the failure, after which requested pages are built from the known part; or null.
        public PointCloudException Update()
        {
            // Jobs that build pages read the lists that would grow.
            if (!IsReading || !JobCoroutine.HasEnded(Step) || !JobCoroutine.HasEnded(m_building))
                return null;
            Step.Complete();
            m_building.Complete();
            try
            {
                if (m_reading == null)
                {
                    m_pageInFlight = m_requestedPage;
                    m_requestedPage = None;
                    var root = m_rootOfPage[m_pageInFlight];
                    m_reading = new CoroutineStack(m_reader.ReadHierarchyBelow(root, EndLevelOf(root)));
                }
                if (m_reading.MoveNext())
                {
                    Step = m_reading.Current;
                    return null;
                }
                EndReading();
                MapNewNodes();
                m_isPageKnown[m_pageInFlight] = true;
                return null;
            }
            catch (PointCloudException failure)
            {
                EndReading();
                MapNewNodes();
                m_isBroken = true;
                for (int page = 0; page < m_isPageKnown.Count; page++)
                    m_isPageKnown[page] = true;
                return failure;
            }
        }

        public BuildTreePageJob JobFor(int page) => new BuildTreePageJob
        {
            Nodes = m_reader.Tree.AsArray(),
            NodeOfKey = m_nodeOfKey,
            Root = m_rootOfPage[page],
            LastLevel = m_rootOfPage[page].w + LevelsPerPage - 1,
            Grid = m_grid,
        };

        public JobHandle Schedule(in BuildTreePageJob job)
        {
            var building = job.Schedule();
            m_building = JobHandle.CombineDependencies(m_building, building);
            return building;
        }

        // Numbers the pages attached to one; the same each time it is built.
        public unsafe void Number(int page, in HierarchyPage built, int planeCount)
        {
            if (m_firstAttachedOfPage[page] == Unnumbered)
            {
                m_firstAttachedOfPage[page] = m_rootOfPage.Count;
                for (int n = 0; n < built.NodeCount; n++)
                    if (built.Nodes[n].PageCount > 0)
                        AddAttached(m_reader.Tree[(int)built.Planes[n * planeCount].OffsetBytes].Key);
            }
            int next = m_firstAttachedOfPage[page];
            for (int n = 0; n < built.NodeCount; n++)
            {
                built.Nodes[n].FirstPage = next;
                next += built.Nodes[n].PageCount;
            }
        }

        public HierarchyPage CreateEmpty(int page)
        {
            var empty = new HierarchyPage();
            m_grid.BoxOf(m_rootOfPage[page], out empty.Center, out empty.Half);
            return empty;
        }

        public void Dispose()
        {
            Step.Complete();
            m_building.Complete();
            EndReading();
            if (m_nodeOfKey.IsCreated)
                m_nodeOfKey.Dispose();
        }

        void EndReading()
        {
            m_reading?.Dispose();
            m_reading = null;
        }

        void AddAttached(int4 key)
        {
            for (int octant = 0; octant < 8; octant++)
            {
                int4 child = BuildTreePageJob.ChildKey(key, octant);
                if (!m_nodeOfKey.ContainsKey(child))
                    continue;
                m_rootOfPage.Add(child);
                m_firstAttachedOfPage.Add(Unnumbered);
                m_isPageKnown.Add(m_isBroken || m_reader.IsKnownBelow(child, EndLevelOf(child)));
            }
        }

        void MapNewNodes()
        {
            var tree = m_reader.Tree;
            for (; m_nodes < tree.NodeCount; m_nodes++)
                m_nodeOfKey.TryAdd(tree[m_nodes].Key, m_nodes);
        }

        // Its own, and one more to know whether there are others.
        static int EndLevelOf(int4 root) => root.w + LevelsToKnow;
    }

    // A page of the hierarchy: a node of a source's own octree and what is below it, some levels deep.
    [BurstCompile]
    internal unsafe struct BuildTreePageJob : IJob
    {
        [ReadOnly] public NativeArray<SourceNode> Nodes;
        [ReadOnly] public NativeParallelHashMap<int4, int> NodeOfKey; // The first node of each SourceNode.Key.

        // Bits of a point in each streamed plane; the position's depend on the node.
        [ReadOnly] public NativeArray<int> BitsOfPlane;

        [ReadOnly] public NativeArray<PlaneShape> Shapes;
        public int4 Root;

        // Nodes below this level are attached to the page as pages of their own.
        public int LastLevel;
        public TreeGrid Grid;

        // Its memory belongs to the code that takes it. PageCount of a node is the number of pages attached to it; OffsetBytes
        // is the number of the source's node, in every plane of a node.
        public NativeReference<HierarchyPage> Built;
        public NativeReference<TableProblem> Problem;

        public void Execute()
        {
            var order = new NativeList<int>(64, Allocator.Temp);
            var firstChild = new NativeList<int>(64, Allocator.Temp);
            order.Add(NodeOfKey[Root]);
            for (int at = 0; at < order.Length; at++)
            {
                firstChild.Add(order.Length);
                AddChildren(order[at], order);
            }
            firstChild.Add(order.Length);

            var page = new HierarchyPage();
            page.Allocate(order.Length, Shapes.Length);
            page.RootCount = 1;
            for (int n = 0; n < order.Length; n++)
                Fill(page, n, order[n], firstChild[n], firstChild[n + 1]);
            page.Status = HierarchyPageStatus.Loaded;
            Built.Value = page;
            Problem.Value = default;
            firstChild.Dispose();
            order.Dispose();
        }

        void AddChildren(int index, NativeList<int> order)
        {
            int4 key = Nodes[index].Key;
            if (NodeOfKey[key] != index)
                return;
            for (int more = index + 1; more < Nodes.Length && math.all(Nodes[more].Key == key); more++)
                order.Add(more);
            for (int octant = 0; octant < 8 && key.w < LastLevel; octant++)
                if (NodeOfKey.TryGetValue(ChildKey(key, octant), out int child))
                    order.Add(child);
        }

        public static int4 ChildKey(int4 key, int octant) =>
            new int4(2 * key.x + (octant & 1), 2 * key.y + (octant >> 1 & 1), 2 * key.z + (octant >> 2), key.w + 1);

        void Fill(in HierarchyPage page, int n, int index, int firstChild, int endOfChildren)
        {
            var source = Nodes[index];
            bool hasPoints = source.Block >= 0 && source.PointCount > 0;
            var node = new StreamNode
            {
                Spacing = (float)Grid.SpacingOf(source.Level),
                FirstChild = firstChild,
                ChildCount = endOfChildren - firstChild,
                // A count of 0 would mark an inlined leaf; a node without points gets 1 and is marked as a hole.
                PointCount = hasPoints ? source.PointCount : 1,
                BlockCount = hasPoints ? PlaneShape.BlocksOf(source.PointCount) : 0,
            };
            for (int octant = 0; octant < 8 && source.Level == LastLevel && NodeOfKey[source.Key] == index; octant++)
                node.PageCount += NodeOfKey.ContainsKey(ChildKey(source.Key, octant)) ? 1 : 0;
            Grid.BoxOf(source.Key, out node.Center, out node.Half);
            page.Nodes[n] = node;
            page.States[n] = new NodeState { Slot = NodeState.NoSlot, Failures = hasPoints ? 0 : NodeState.HoleFailures };
            page.Addresses[n] = new NodeAddress
            {
                Corner = Grid.Corner - Grid.Root.Corner,
                IsWide = Grid.IsWide,
                Level = (byte)source.Level,
            };
            for (int p = 0; p < Shapes.Length; p++)
                page.Planes[n * Shapes.Length + p] = new PlaneRange
                {
                    OffsetBytes = index,
                    LengthBytes = MaxBytesOf(p, source.Level, node.BlockCount, source.PointCount),
                };
        }

        // Upper bound of a plane's bytes if all points lie in the node's cube.
        long MaxBytesOf(int plane, int level, int blocks, int points)
        {
            long bits = BitsOfPlane[plane];
            if (plane == 0)
                bits = math.csum(math.min(Grid.BitsOf(level), Grid.IsWide ? 64 : 32));
            // Columns of each block end at a whole word.
            var shape = plane == 0 && Grid.IsWide ? new PlaneShape(3, 7) : Shapes[plane];
            return PlaneShape.LengthBytes((long)blocks * (shape.DescriptorWords + shape.ColumnCount) + (points * bits + 31) / 32);
        }
    }
}
