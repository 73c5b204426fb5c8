using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // The runs of a node's points, and the tree over them. What descriptors say of blocks is up to twice as large on each axis:
    // a ray would meet some five times the points.
    [BurstCompile]
    internal unsafe struct BuildResidentNodeJob : IJob
    {
        [ReadOnly] public NativeArray<bool> IsDamaged; // By plane.
        public PlaneView Positions;
        public BoxTree Tree;
        [NativeDisableUnsafePtrRestriction] public PointRun* Runs;
        public double3 Step;

        public void Execute()
        {
            for (int plane = 0; plane < IsDamaged.Length; plane++)
                if (IsDamaged[plane])
                    return;
            var runs = (PointRun*)UnsafeUtility.Malloc(Tree.LeafCount * (long)sizeof(PointRun), 8, Allocator.Temp);
            uint* order = (uint*)UnsafeUtility.Malloc(Tree.LeafCount * (long)sizeof(uint), 8, Allocator.Temp);
            ulong* values = stackalloc ulong[NodeSearch.ScratchCount];
            for (int block = 0; block < Positions.BlockCount; block++)
            {
                for (int axis = 0; axis < 3; axis++)
                    Positions.UnpackWide(block, axis, 0, Positions.PointsOf(block), values + axis * PlaneShape.MaxPointsPerBlock);
                var runsOfBlock = runs + block * PointRun.PerBlock;
                FindRuns(block, values, runsOfBlock);
                for (int run = 0; run < PointRun.PerBlock; run++)
                    for (int axis = 0; axis < 3; axis++)
                        SetAxis(ref Tree.Eights[block], run, axis, values, runsOfBlock[run]);
            }
            Tree.Order(order);
            for (int i = 0; i < Tree.LeafCount; i++)
                Runs[i] = runs[order[i]];
            Tree.Build();
            UnsafeUtility.Free(order, Allocator.Temp);
            UnsafeUtility.Free(runs, Allocator.Temp);
        }

        // Along the Morton curve neighbours lie close together but for jumps: runs end at the longest, of equal ones at those
        // that make runs equal.
        void FindRuns(int block, ulong* values, PointRun* runs)
        {
            const int MaxEnds = PointRun.PerBlock - 1, EqualRun = PlaneShape.MaxPointsPerBlock / PointRun.PerBlock;
            const double Preference = 1.01;
            int points = Positions.PointsOf(block), count = 0, first = 0;
            double* jumps = stackalloc double[MaxEnds];
            int* ends = stackalloc int[MaxEnds];
            for (int i = 1; i < points; i++)
            {
                double jump = 0;
                for (int axis = 0; axis < 3; axis++)
                {
                    ulong* value = values + axis * PlaneShape.MaxPointsPerBlock + i;
                    jump = math.max(jump, math.abs((double)(long)(value[0] - value[-1])) * Step[axis]);
                }
                jump = i % EqualRun == 0 ? jump * Preference + double.Epsilon : jump;
                int shortest = count == MaxEnds ? 0 : count;
                for (int end = 1; end < count && count == MaxEnds; end++)
                    shortest = jumps[end] < jumps[shortest] ? end : shortest;
                if (count == MaxEnds && jump <= jumps[shortest])
                    continue;
                count = math.min(count, MaxEnds - 1);
                for (int end = shortest; end < count; end++)
                    (jumps[end], ends[end]) = (jumps[end + 1], ends[end + 1]);
                (jumps[count], ends[count]) = (jump, i);
                count++;
            }
            for (int run = 0; run < PointRun.PerBlock; run++)
            {
                int end = run < count ? ends[run] : points;
                runs[run] = new PointRun { Block = block, First = (short)first, Count = (short)(end - first) };
                first = end;
            }
        }

        // A run without points lies at the block's end.
        void SetAxis(ref EightBoxes boxes, int box, int axis, ulong* values, in PointRun run)
        {
            values += axis * PlaneShape.MaxPointsPerBlock;
            int first = math.min(run.First, Positions.PointsOf(run.Block) - 1);
            ulong min = values[first], max = min;
            for (int i = first + 1; i < first + run.Count; i++)
            {
                min = math.min(min, values[i]);
                max = math.max(max, values[i]);
            }
            boxes.Set(box, axis, min * Step[axis], max * Step[axis]);
        }
    }

    // Points of a block that follow one another and lie close together.
    internal struct PointRun
    {
        public const int PerBlock = BoxTree.FanOut; // Some without points if there are too few.
        public int Block;
        public short First;
        public short Count;
    }
}
