using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // The boxes of runs of a node's points, and the tree over them. What descriptors say of blocks is up to twice as large on
    // each axis: a ray would meet some five times the points.
    [BurstCompile]
    internal unsafe struct BuildResidentNodeJob : IJob
    {
        [ReadOnly] public NativeArray<bool> IsDamaged; // By plane.
        public PlaneView Positions;
        public BoxTree Tree;
        public double3 Step;

        public void Execute()
        {
            for (int plane = 0; plane < IsDamaged.Length; plane++)
                if (IsDamaged[plane])
                    return;
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            for (int block = 0; block < Positions.BlockCount; block++)
                for (int axis = 0; axis < 3; axis++)
                {
                    Positions.UnpackWide(block, axis, values);
                    for (int run = 0; run < ResidentNode.RunsPerBlock; run++)
                        SetAxis(ref Tree.Eights[block], run, axis, values, Positions.PointsOf(block));
                }
            Tree.Build();
        }

        // A run without points lies at the block's end.
        void SetAxis(ref EightBoxes boxes, int run, int axis, ulong* values, int points)
        {
            int first = run * ResidentNode.PointsPerRun, end = math.min(first + ResidentNode.PointsPerRun, points);
            first = math.min(first, points - 1);
            ulong min = values[first], max = min;
            for (int i = first + 1; i < end; i++)
            {
                min = math.min(min, values[i]);
                max = math.max(max, values[i]);
            }
            boxes.Set(run, axis, min * Step[axis], max * Step[axis]);
        }
    }
}
