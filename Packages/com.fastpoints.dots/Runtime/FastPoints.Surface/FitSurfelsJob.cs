using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>A slice of making a surfel of each voxel: its points' mean, moved onto the plane through those around it. All
    /// sums go in the order of places and count from the voxel, so that each cell that has it makes the same surfel.</summary>
    [BurstCompile]
    internal unsafe struct FitSurfelsJob : IJob
    {
        public const int VoxelsPerSlice = 1200; // A slice takes about a millisecond.
        const float Radius = 2.5f; // Voxels farther away than this do not count.
        const float MaxMove = 0.5f; // The longest way of a mean to the plane: beyond, it is no noise but another wall.
        const float MaxAcross = 0.5f; // What deviates more from a plane is none, such as leaves.

        public int First;
        public int End;
        public SurfaceGrid Grid;
        public float3 Up; // The normal of what has none: single points and lines.
        public SurfaceMemory Memory;
        public SliceTimes Times;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int side = Grid.SideWithMargins;
            var voxels = Memory.Voxels.GetUnsafePtr();
            var means = Memory.Means.GetUnsafePtr();
            var surfels = Memory.Surfels.GetUnsafePtr();
            for (int i = First; i < End; i++)
            {
                int at = voxels[i].At;
                var place = new int3(at % side, at / side % side, at / (side * side));
                var own = means[i];
                var surfel = new Surfel { Position = own, Normal = Up };
                if (math.all(place >= SurfaceGrid.FitReach) && math.all(place < side - SurfaceGrid.FitReach))
                    Fit(at, own, ref surfel);
                surfels[i] = surfel;
            }
            Times.End(begin);
        }

        void Fit(int at, float3 own, ref Surfel surfel)
        {
            const int reach = SurfaceGrid.FitReach;
            int side = Grid.SideWithMargins;
            var surfelOf = (int*)Memory.SurfelOf.GetUnsafePtr();
            var means = Memory.Means.GetUnsafePtr();
            var sums = new OffsetSums { Count = 1 };
            float weights = 0;
            for (int z = -reach; z <= reach; z++)
                for (int y = -reach; y <= reach; y++)
                {
                    var row = surfelOf + at + side * (y + side * z);
                    // Most rows are empty.
                    if ((row[-2] | row[-1] | row[0] | row[1] | row[2]) == 0)
                        continue;
                    for (int x = -reach; x <= reach; x++)
                    {
                        int number = row[x];
                        if (number <= 0)
                            continue;
                        var offset = means[number - 1] - own + new float3(x, y, z);
                        float weight = 1 - math.lengthsq(offset) * (1 / (Radius * Radius));
                        if (weight <= 0)
                            continue;
                        weight *= weight;
                        weights += weight;
                        sums.Offset += weight * offset;
                        sums.Squares += weight * offset * offset;
                        sums.Mixed += weight * new float3(offset.x * offset.y, offset.x * offset.z, offset.y * offset.z);
                    }
                }
            float share = 1 / weights;
            sums.Offset *= share;
            sums.Squares *= share;
            sums.Mixed *= share;
            if (!PlaneFit.TryFit(sums, out var normal))
                return;
            surfel.Normal = normal;
            var squares = sums.Squares - sums.Offset * sums.Offset;
            var mixed = sums.Mixed - new float3(sums.Offset.x * sums.Offset.y, sums.Offset.x * sums.Offset.z,
                sums.Offset.y * sums.Offset.z);
            float across = math.dot(squares, normal * normal) + 2 * math.dot(mixed,
                new float3(normal.x * normal.y, normal.x * normal.z, normal.y * normal.z));
            if (across > MaxAcross * MaxAcross)
                return;
            surfel.Position = own + normal * math.clamp(math.dot(normal, sums.Offset), -MaxMove, MaxMove);
        }
    }

    [BurstCompile]
    internal unsafe struct AverageVoxelsJob : IJob
    {
        public const int VoxelsPerSlice = 100000; // A slice takes about a millisecond.

        public int First;
        public int End;
        public SurfaceMemory Memory;

        public void Execute()
        {
            var voxels = Memory.Voxels.GetUnsafePtr();
            var means = Memory.Means.GetUnsafePtr();
            for (int i = First; i < End; i++)
                means[i] = new float3(voxels[i].X, voxels[i].Y, voxels[i].Z) * (1f /
                    (CollectVoxelsJob.SumStepsPerVoxel * (float)voxels[i].Count)) + 0.5f / CollectVoxelsJob.SumStepsPerVoxel;
        }
    }
}
