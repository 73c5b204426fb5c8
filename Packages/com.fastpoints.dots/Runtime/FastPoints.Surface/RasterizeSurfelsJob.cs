using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>A slice of marking the lattice points in a shell around the surfels: a flat cylinder each. It is thick enough
    /// that no line between two lattice points passes it, whichever way it faces, and wide enough that cylinders of
    /// neighbouring voxels overlap. Slices run one after another.</summary>
    [BurstCompile]
    internal unsafe struct RasterizeSurfelsJob : IJob
    {
        public const int SurfelsPerSlice = 5000; // A slice takes about a millisecond.
        internal const float HalfHeight = 0.75f; // Half of a cylinder's height, and its radius, in voxels.
        internal const float Radius = 1.3f;
        const float Reach = 1.51f; // From its centre to its rim's edge.

        public int First;
        public int End;
        public SurfaceGrid Grid;
        public SurfaceMemory Memory;
        public SliceTimes Times;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int side = Grid.SideWithMargins;
            var isInside = (byte*)Memory.IsInside.GetUnsafePtr();
            var isRowInside = (byte*)Memory.IsRowInside.GetUnsafePtr();
            for (int i = First; i < End; i++)
            {
                int at = Memory.Voxels[i].At;
                var place = new int3(at % side, at / side % side, at / (side * side));
                var surfel = Memory.Surfels[i];
                // Counted from its voxel: rounding is the same in each cell that has it.
                var first = math.max((int3)math.ceil(surfel.Position - Reach), new int3(0) - place);
                var last = math.min((int3)math.floor(surfel.Position + Reach), new int3(side - 1) - place);
                for (int z = first.z; z <= last.z; z++)
                    for (int y = first.y; y <= last.y; y++)
                    {
                        int row = place.y + y + side * (place.z + z);
                        for (int x = first.x; x <= last.x; x++)
                        {
                            var offset = new float3(x, y, z) - surfel.Position;
                            float height = math.dot(offset, surfel.Normal);
                            float across = math.lengthsq(offset) - height * height;
                            if (math.abs(height) > HalfHeight || across > Radius * Radius)
                                continue;
                            isInside[side * row + place.x + x] = 1;
                            isRowInside[row] = 1;
                        }
                    }
            }
            Times.End(begin);
        }
    }
}
