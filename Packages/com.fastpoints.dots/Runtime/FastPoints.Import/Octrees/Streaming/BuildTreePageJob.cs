using FastPoints.Reading;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // A page of the hierarchy: a node of a source's own octree and what is below it, some levels deep.
    [BurstCompile]
    internal unsafe struct BuildTreePageJob : IJob
    {
        [ReadOnly] public NativeArray<SourceNode> Nodes;

        // The first node of each SourceNode.Key.
        [ReadOnly] public NativeParallelHashMap<int4, int> NodeOfKey;

        // Of a point in each streamed plane; the position's depend on the node.
        [ReadOnly] public NativeArray<int> BitsOfPlane;

        [ReadOnly] public NativeArray<PlaneShape> Shapes;
        public int4 Root;

        // Nodes below this level are attached to the page as pages of their own.
        public int LastLevel;
        public TreeGrid Grid;

        // Its memory belongs to the code that takes it. ChunkCount of a node is the number of pages attached to it; OffsetBytes
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

        // More blocks of the same node, then its children.
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
                // A node without points would be an inlined leaf: one that only holds others together is a hole.
                PointCount = hasPoints ? source.PointCount : 1,
                BlockCount = hasPoints ? PlaneShape.BlocksOf(source.PointCount) : 0,
            };
            for (int octant = 0; octant < 8 && source.Level == LastLevel && NodeOfKey[source.Key] == index; octant++)
                node.ChunkCount += NodeOfKey.ContainsKey(ChildKey(source.Key, octant)) ? 1 : 0;
            Grid.BoxOf(source.Key, out node.Center, out node.Half);
            page.Nodes[n] = node;
            page.States[n] = new NodeState { Slot = NodeState.NoSlot, Failures = hasPoints ? 0 : NodeState.IsHole };
            page.Places[n] = new NodeAddress
            {
                Corner = Grid.Corner - Grid.Root.Corner,
                IsWide = Grid.IsWide,
                Level = (byte)source.Level,
            };
            for (int p = 0; p < Shapes.Length; p++)
                page.Planes[n * Shapes.Length + p] = new PlaneRange
                {
                    OffsetBytes = index,
                    LengthBytes = LongestOf(p, source.Level, node.BlockCount, source.PointCount),
                };
        }

        // If all points lie in their cube.
        long LongestOf(int plane, int level, int blocks, int points)
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
