using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // The boxes of a node's blocks, and the tree over them. Descriptors allow up to twice the extent that points have, and rays
    // would meet four times the blocks: so the largest values are looked up.
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
            {
                double3 min = default, max = default;
                for (int axis = 0; axis < 3; axis++)
                {
                    Positions.UnpackWide(block, axis, values);
                    ulong largest = 0;
                    for (int i = 0; i < Positions.PointsOf(block); i++)
                        largest = math.max(largest, values[i]);
                    min[axis] = Positions.MinimumOf(block, axis);
                    max[axis] = largest;
                }
                Tree.Boxes[block] = new LocalBox(min * Step, max * Step);
            }
            Tree.Build();
        }
    }
}
