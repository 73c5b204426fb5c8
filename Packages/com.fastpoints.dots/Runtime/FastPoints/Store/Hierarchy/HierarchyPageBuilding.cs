using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Store
{
    internal static unsafe class HierarchyPageBuilding
    {
        // From a page without problems. Its nodes number the pages below from 0 on, until they are registered.
        public static void Build(in PageView stored, NativeArray<int> wanted, in CloudLocalSpace grid, ref HierarchyPage page)
        {
            int nodeCount = stored.NodeCount, planeCount = stored.Header.PlaneCount;
            var records = stored.Nodes;
            var ranges = stored.Ranges;
            page.Allocate(nodeCount, wanted.Length);
            var boxes = new NativeArray<LocalBox>(nodeCount, Allocator.Temp, NativeArrayOptions.UninitializedMemory);
            for (int n = 0; n < nodeCount; n++)
                boxes[n] = OwnBox(records[n], grid);
            // Children come after their parents.
            for (int n = nodeCount - 1; n >= 0; n--)
            {
                var node = records[n];
                var box = boxes[n];
                for (int l = node.FirstLink; l < node.FirstLink + node.LinkCount; l++)
                {
                    grid.BoxOf(stored.Links[l].Cube, out var center, out var half);
                    box = Union(box, new LocalBox(center - half, center + half));
                }
                boxes[n] = box;
                if (node.Parent >= 0)
                    boxes[node.Parent] = Union(boxes[node.Parent], box);
            }
            for (int n = 0; n < nodeCount; n++)
            {
                page.RootCount += records[n].Parent < 0 ? 1 : 0;
                page.Nodes[n] = NodeOf(records, n, boxes[n], grid);
                page.States[n] = new NodeState { Slot = NodeState.NoSlot };
                page.Addresses[n] = new NodeAddress
                {
                    Corner = records[n].Corner - grid.Corner,
                    IsWide = records[n].IsWide,
                    Level = (byte)(grid.RootSideLog2 - records[n].SideLog2),
                };
                for (int p = 0; p < wanted.Length; p++)
                    page.Planes[n * wanted.Length + p] = ranges[(long)n * planeCount + wanted[p]].Range;
            }
            boxes.Dispose();
            page.Status = HierarchyPageStatus.Loaded;
        }

        static StreamNode NodeOf(NodeRecord* records, int n, LocalBox box, in CloudLocalSpace grid)
        {
            var record = records[n];
            var node = new StreamNode
            {
                Spacing = (float)(math.cmax(grid.Step) * math.pow(2.0, record.CellLog2)),
                FirstChild = record.FirstChild,
                ChildCount = record.ChildCount,
                FirstPage = record.FirstLink,
                PageCount = record.LinkCount,
                PointCount = record.PlaneNode == n ? record.PointCount : 0,
                BlockCount = record.PlaneBlocks,
            };
            CloudLocalSpace.Box(box.Min, box.Max, out node.Center, out node.Half);
            for (int child = record.FirstChild; record.PlaneNode == n && child < record.FirstChild + record.ChildCount; child++)
                node.PointCount += records[child].PlaneNode == n ? records[child].PointCount : 0;
            return node;
        }

        static LocalBox OwnBox(in NodeRecord node, in CloudLocalSpace grid)
        {
            // Bounds of wide nodes are rounded down to units of several steps.
            int shift = node.BoundsShift;
            long rest = (1L << shift) - 1;
            var min = node.Corner + new Grid3((long)node.MinX << shift, (long)node.MinY << shift, (long)node.MinZ << shift);
            var max = node.Corner + new Grid3(((long)node.MaxX << shift) + rest, ((long)node.MaxY << shift) + rest,
                ((long)node.MaxZ << shift) + rest);
            return new LocalBox(grid.ToLocal(min), grid.ToLocal(max));
        }

        static LocalBox Union(in LocalBox a, in LocalBox b) => new LocalBox(math.min(a.Min, b.Min), math.max(a.Max, b.Max));

        struct LocalBox
        {
            public double3 Min;
            public double3 Max;

            public LocalBox(double3 min, double3 max) => (Min, Max) = (min, max);
        }
    }

    [BurstCompile]
    internal unsafe struct BuildHierarchyPageJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Table;
        public PageLink Link;
        public CloudLocalSpace Grid;
        [ReadOnly] public NativeArray<PlaneShape> Shapes;
        public int ComputedPlaneCount; // The last of these.
        [ReadOnly] public NativeArray<int> Wanted;

        // The page, if Problem is none; the code that takes it owns its memory.
        public NativeReference<HierarchyPage> Built;
        public NativeReference<TableProblem> Problem;

        public TableCheck Check =>
            new TableCheck(Table, Link, Grid, (PlaneShape*)Shapes.GetUnsafeReadOnlyPtr(), Shapes.Length, ComputedPlaneCount);

        public void Execute()
        {
            Problem.Value = Check.FindProblem();
            if (!Problem.Value.IsNone)
                return;
            var page = new HierarchyPage();
            HierarchyPageBuilding.Build(PageView.Of(Table), Wanted, Grid, ref page);
            Built.Value = page;
        }
    }
}
