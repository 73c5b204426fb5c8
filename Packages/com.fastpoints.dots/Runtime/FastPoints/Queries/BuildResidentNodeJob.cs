using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // The runs of each block's points, with their boxes. What descriptors say of blocks is up to twice as large on each axis: a
    // ray would meet some five times the points.
    [BurstCompile]
    internal unsafe struct FindRunsJob : IJobFor
    {
        public const int BlocksPerSlice = 64;

        [ReadOnly] public NativeArray<bool> IsDamaged; // By plane.
        public PlaneView Positions;
        public BoxTree Tree;
        [NativeDisableUnsafePtrRestriction] public PointRun* Runs;
        public double3 Step;

        public void Execute(int block)
        {
            if (IsAny(IsDamaged))
                return;
            ulong* values = stackalloc ulong[NodeSearch.ScratchCount];
            for (int axis = 0; axis < 3; axis++)
                Positions.UnpackWide(block, axis, 0, Positions.PointsOf(block), values + axis * PlaneShape.MaxPointsPerBlock);
            var runs = Runs + block * PointRun.PerBlock;
            FindRuns(block, values, runs);
            for (int run = 0; run < PointRun.PerBlock; run++)
                for (int axis = 0; axis < 3; axis++)
                    SetAxis(ref Tree.Eights[block], run, axis, values, runs[run]);
        }

        public static bool IsAny(NativeArray<bool> flags)
        {
            bool isAny = false;
            for (int i = 0; i < flags.Length; i++)
                isAny |= flags[i];
            return isAny;
        }

        // Along the Morton curve neighbours lie close together but for jumps: runs end at the longest, of equal ones at those
        // that make runs equal.
        void FindRuns(int block, ulong* values, PointRun* runs)
        {
            const int MaxEnds = PointRun.PerBlock - 1, EqualRun = PlaneShape.MaxPointsPerBlock / PointRun.PerBlock;
            const double Preference = 1.01;
            int points = Positions.PointsOf(block), count = 0, first = 0, shortest = 0;
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
                if (count == MaxEnds)
                {
                    if (jump <= jumps[shortest])
                        continue;
                    count--;
                    for (int end = shortest; end < count; end++)
                        (jumps[end], ends[end]) = (jumps[end + 1], ends[end + 1]);
                }
                (jumps[count], ends[count]) = (jump, i);
                count++;
                shortest = 0;
                for (int end = 1; end < count; end++)
                    shortest = jumps[end] < jumps[shortest] ? end : shortest;
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

    // The tree over a node's runs, which come into its order.
    [BurstCompile]
    internal unsafe struct BuildResidentNodeJob : IJob
    {
        const int MaxOrdered = 1 << 14; // Beyond, some 260,000 points, it would take more than a slice: they stay as they are.

        [ReadOnly] public NativeArray<bool> IsDamaged; // By plane.
        public BoxTree Tree;
        [NativeDisableUnsafePtrRestriction] public PointRun* Runs;

        public void Execute()
        {
            if (FindRunsJob.IsAny(IsDamaged) || Tree.LeafCount == 0)
                return;
            if (Tree.LeafCount <= MaxOrdered)
            {
                var from = new NativeArray<PointRun>(Tree.LeafCount, Allocator.Temp, NativeArrayOptions.UninitializedMemory);
                var order = new NativeArray<uint>(Tree.LeafCount, Allocator.Temp, NativeArrayOptions.UninitializedMemory);
                UnsafeUtility.MemCpy(from.GetUnsafePtr(), Runs, from.Length * (long)sizeof(PointRun));
                Tree.Order((uint*)order.GetUnsafePtr());
                for (int i = 0; i < order.Length; i++)
                    Runs[i] = from[(int)order[i]];
            }
            Tree.Build();
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
