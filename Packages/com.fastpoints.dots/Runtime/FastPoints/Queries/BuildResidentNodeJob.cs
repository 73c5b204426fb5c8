using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // The boxes of a node's blocks, from their descriptors, and the tree over them.
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
            var search = new NodeSearch { Positions = Positions, Step = Step };
            for (int block = 0; block < Positions.BlockCount; block++)
            {
                var center = search.BoxOf(block, out var half);
                Tree.Boxes[block] = new LocalBox(center - half, center + half);
            }
            Tree.Build();
        }
    }
}
