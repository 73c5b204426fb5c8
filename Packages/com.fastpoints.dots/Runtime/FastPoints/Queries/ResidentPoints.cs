using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    /// <summary>The points of a stream's clouds that are in memory, to be searched on any thread and in Burst jobs, without
    /// garbage. See <see cref="PointCloudQueries.Resident"/>.</summary>
    public unsafe struct ResidentPoints
    {
        [ReadOnly] internal NativeArray<ResidentCloud> Clouds;
        [ReadOnly] internal NativeArray<ResidentNode> Nodes;
        [ReadOnly] internal NativeArray<int> ChildrenOfNodes;
        const int MaxOnStack = 16; // Heaps of up to this many hits lie on the stack.

        /// <summary>Finds the first point that a query asks for. Returns whether there is one.</summary>
        public bool TryFindFirst(in PointQuery query, out PointHit hit)
        {
            var found = default(PickHit);
            var heap = new HitHeap(&found, 1, false, PickHit.None);
            Search(query, ref heap);
            hit = heap.Totals.Count > 0 ? Describe(found) : default;
            return heap.Totals.Count > 0;
        }

        /// <summary>Finds as many of the first points as there is room for, the first one first.</summary>
        /// <returns>How many were found.</returns>
        public int Find(in PointQuery query, NativeArray<PointHit> hits) =>
            Find(query, (PointHit*)hits.GetUnsafePtr(), hits.Length);

        /// <summary>Counts the points that a query asks for.</summary>
        public long Count(in PointQuery query)
        {
            var heap = new HitHeap(null, 0, true, default);
            Search(query, ref heap);
            return heap.Totals.Matches;
        }

        internal int Find(in PointQuery query, PointHit* hits, int capacity)
        {
            PickHit* onStack = stackalloc PickHit[MaxOnStack];
            var large = capacity > MaxOnStack
                ? (PickHit*)UnsafeUtility.Malloc((long)capacity * sizeof(PickHit), 8, Allocator.TempJob) : null;
            var heap = new HitHeap(large != null ? large : onStack, capacity, false, PickHit.None);
            Search(query, ref heap);
            heap.Sort();
            for (int i = 0; i < heap.Totals.Count; i++)
                hits[i] = Describe(heap[i]);
            if (large != null)
                UnsafeUtility.Free(large, Allocator.TempJob);
            return heap.Totals.Count;
        }

        // A hit's cloud is its index in Clouds here, and its node the index in Nodes.
        void Search(in PointQuery query, ref HitHeap hits)
        {
            ulong* scratch = stackalloc ulong[NodeSearch.ScratchCount];
            var clouds = (ResidentCloud*)Clouds.GetUnsafeReadOnlyPtr();
            var nodes = (ResidentNode*)Nodes.GetUnsafeReadOnlyPtr();
            for (int c = 0; c < Clouds.Length; c++)
            {
                if (!clouds[c].Placement.IsValid)
                    continue;
                var space = new QuerySpace(query, clouds[c].Placement);
                var search = new NodeSearch
                {
                    Space = space,
                    Filter = new BlockFilter(query, space, clouds[c].Grid.Step),
                    Step = clouds[c].Grid.Step,
                    RootCorner = clouds[c].RootCorner,
                    Cloud = c,
                };
                Walk(clouds[c], nodes, ref search, scratch, ref hits);
            }
        }

        // From the nearest box on: the cloud's leaves are nodes, those of a node are runs of its points.
        static void Walk(in ResidentCloud cloud, ResidentNode* nodes, ref NodeSearch search, ulong* scratch, ref HitHeap hits)
        {
            var items = stackalloc PendingBox[2 * BoxTree.MaxPending];
            var rays = stackalloc BoxTreeRay[2];
            var pending = new PendingBoxes { Items = items, Rays = rays };
            pending.Begin(cloud.Tree, PendingBox.NoNode, search.Space, hits.Limit);
            while (pending.Count > 0)
            {
                var next = items[--pending.Count];
                if (next.Distance > hits.Limit)
                    continue;
                if (next.Level > 0)
                {
                    var tree = next.Node < 0 ? cloud.Tree : nodes[next.Node].Tree;
                    pending.Push(tree, next, search.Space, hits.Limit);
                }
                else if (next.Node < 0)
                {
                    search.Node = cloud.FirstNode + next.Index;
                    search.Corner = nodes[search.Node].Corner;
                    search.Positions = nodes[search.Node].Positions;
                    pending.Begin(nodes[search.Node].Tree, search.Node, search.Space, hits.Limit);
                }
                else
                {
                    var run = nodes[next.Node].Runs[next.Index];
                    search.Search(run.Block, run.First, run.Count, scratch, ref hits);
                }
            }
        }

        PointHit Describe(in PickHit hit)
        {
            var cloud = Clouds[hit.Cloud];
            var node = Nodes[hit.Node];
            var from = hit.Position - cloud.RootCorner;
            var local = new double3(from.X, from.Y, from.Z) * cloud.Grid.Step;
            ushort normal = NodeSearch.NormalAt(node.Normals, hit.Block, hit.Index);
            return new PointHit
            {
                PositionWorld = math.mul(cloud.Placement.Linear, local) + cloud.Placement.OriginWorld,
                PositionGeo = cloud.Grid.ToGeo(hit.Position),
                Position = hit.Position,
                Distance = hit.Distance,
                NormalWorld = OctahedralNormal.ToWorld(normal, cloud.NormalsToWorld),
                SpacingWorld = SpacingAt(hit.Node, local) * cloud.LargestScale,
                Cloud = cloud.Number,
                Slot = node.Slot,
                Version = node.Version,
                Block = hit.Block,
                Index = hit.Index,
            };
        }

        // Down the nodes that are in memory and whose boxes hold the position.
        double SpacingAt(int node, double3 local)
        {
            for (int child = 0; child < Nodes[node].ChildCount; child++)
            {
                int below = ChildrenOfNodes[Nodes[node].FirstChild + child];
                if (!Nodes[below].Holds(local))
                    continue;
                node = below;
                child = -1;
            }
            return Nodes[node].HasAllBelow ? 0 : Nodes[node].Spacing;
        }

        struct PendingBox
        {
            public const int NoNode = -1;
            public double Distance;
            public int Node; // Or none, of the tree over nodes.
            public int Level;
            public int Index;
        }

        // Those of the node that is searched lie above those of the tree over nodes.
        struct PendingBoxes
        {
            [NativeDisableUnsafePtrRestriction] public PendingBox* Items;
            [NativeDisableUnsafePtrRestriction] public BoxTreeRay* Rays; // For the tree over nodes and the node.
            public int Count;

            public void Begin(in BoxTree tree, int node, in QuerySpace space, double limit)
            {
                if (tree.LeafCount == 0)
                    return;
                if (space.IsRay)
                    Rays[node < 0 ? 0 : 1] = space.RayFor(tree);
                Push(tree, new PendingBox { Node = node, Level = tree.LevelBelowRoot + 1 }, space, limit);
            }

            // The nearest of a parent's boxes comes on top; those beyond the limit are left out.
            public void Push(in BoxTree tree, in PendingBox parent, in QuerySpace space, double limit)
            {
                int level = parent.Level - 1, bottom = Count, first = parent.Index * BoxTree.FanOut;
                var boxes = tree.BoxesOfLevel(level, out int boxCount) + parent.Index;
                var ray = Rays + (parent.Node < 0 ? 0 : 1);
                float* starts = stackalloc float[BoxTree.FanOut];
                uint hits = 0xFFu >> math.max(0, first + BoxTree.FanOut - boxCount);
                if (space.IsRay)
                    hits &= (uint)BoxTreeRay.Intersect(ray, boxes, starts);
                for (; hits != 0; hits &= hits - 1)
                {
                    int box = math.tzcnt(hits), at = Count;
                    double distance;
                    if (space.IsRay)
                        distance = ray->Base + starts[box];
                    else
                    {
                        boxes->Get(box, out var middle, out var half);
                        if (!space.Intersects(middle + tree.Corner, half, out distance))
                            continue;
                    }
                    if (distance > limit)
                        continue;
                    for (; at > bottom && Items[at - 1].Distance < distance; at--)
                        Items[at] = Items[at - 1];
                    Items[at] = new PendingBox { Distance = distance, Node = parent.Node, Level = level, Index = first + box };
                    Count++;
                }
            }
        }
    }

    internal struct ResidentCloud
    {
        public int Number; // In the stream.
        public CloudPlacement Placement;
        public CloudGrid Grid;
        public Grid3 RootCorner;
        public double3 Metres; // Of a unit, along the axes of normals.
        public double3x3 NormalsToWorld;
        public double LargestScale; // World units of a CRS unit.
        public int FirstNode;
        public BoxTree Tree; // Of its nodes.
    }

    internal unsafe struct ResidentNode
    {
        public int Slot; // In the cache, with its version.
        public int Version;
        public PlaneView Positions;
        public PlaneView Normals; // No words if there are none.
        public Grid3 Corner; // From the root's.
        public BoxTree Tree; // Of runs of its points.
        [NativeDisableUnsafePtrRestriction] public PointRun* Runs;
        public double3 Center; // Of the box around all points from here down, in CRS units from the root's corner.
        public double3 Half;
        public float Spacing;
        public bool HasAllBelow; // No node directly below is missing.
        public int FirstChild; // Among those that are in memory.
        public int ChildCount;

        const double Rounding = 1e-6; // What a float rounds away at the ends of the box.

        public readonly bool Holds(double3 local) => math.all(math.abs(local - Center) <= Half * (1 + Rounding));
    }
}
