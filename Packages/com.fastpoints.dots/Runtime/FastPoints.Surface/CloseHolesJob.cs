using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>A slice of closing holes by surfels in empty voxels beside others: where surfels of one plane are on all
    /// sides, none of them farther than a hole is wide. An edge has some on one side only, so nothing grows over it. What is
    /// decided depends on the points alone, not on the order. Slices run one after another.</summary>
    [BurstCompile]
    internal unsafe struct CloseHolesJob : IJob
    {
        public const int SurfelsPerSlice = 1000; // A slice takes about 1.5 ms.

        const int MaxSide = (int)SurfaceGrid.MaxHoleVoxels * 2 + 1;
        const int MaxNear = MaxSide * MaxSide * MaxSide / 4; // Surfels that decide on a voxel.
        const int Sectors = 16;
        const int MaxEmptySectors = 6; // So many sectors in a row without a surfel may be wider than half a circle.
        const float MinDistance = 0.75f; // Closer than this there is a surfel already.
        const float MaxHeight = 0.6f; // One layer of voxels is that near to a plane.

        /// <summary>Surfels are of one plane whose normals have at least this cosine, and that are no farther off it than
        /// this.</summary>
        const float MinCosine = 0.7f;
        const float MaxOffPlane = 1;

        public int First;
        public int End;
        public SurfaceGrid Grid;
        public int Measured; // How many surfels are made of points.
        public SurfaceMemory Memory;
        public SliceTimes Times;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int side = Grid.SideWithMargins, reach = math.max(1, Grid.HoleReach);
            var surfelOf = (int*)Memory.SurfelOf.GetUnsafePtr();
            var near = stackalloc Surfel[MaxNear];
            for (int i = First; i < End; i++)
            {
                int at = Memory.Voxels[i].At;
                for (int n = 0; n < 27; n++)
                {
                    int next = at + n % 3 - 1 + side * (n / 3 % 3 - 1 + side * (n / 9 - 1));
                    if (next < 0 || next >= side * side * side || surfelOf[next] != 0)
                        continue;
                    var place = new int3(next % side, next / side % side, next / (side * side));
                    if (math.any(place < reach) || math.any(place >= side - reach))
                        continue;
                    surfelOf[next] = SurfaceMemory.Rejected;
                    if (IsOffPlaneOrTaken(next) || !TryClose(next, near, out var surfel))
                        continue;
                    Memory.Voxels.Add(new SurfaceVoxel { At = next });
                    Memory.Surfels.Add(surfel);
                    surfelOf[next] = Memory.Surfels.Length;
                }
            }
            Times.End(begin);
        }

        /// <summary>Whether a surfel beside it says so: most voxels above or below a surface are left out by that.</summary>
        bool IsOffPlaneOrTaken(int at)
        {
            int side = Grid.SideWithMargins;
            var surfelOf = (int*)Memory.SurfelOf.GetUnsafePtr();
            var surfels = Memory.Surfels.GetUnsafePtr();
            float nearest = float.MaxValue;
            bool isOff = false;
            for (int z = -1; z <= 1; z++)
                for (int y = -1; y <= 1; y++)
                    for (int x = -1; x <= 1; x++)
                    {
                        int number = surfelOf[at + x + side * (y + side * z)];
                        if (number <= 0 || number > Measured)
                            continue;
                        var offset = surfels[number - 1].Position + new float3(x, y, z) - 0.5f;
                        float distanceSq = math.lengthsq(offset);
                        if (distanceSq >= nearest)
                            continue;
                        nearest = distanceSq;
                        isOff = math.abs(math.dot(offset, surfels[number - 1].Normal)) > MaxHeight + 0.2f;
                    }
            return isOff || nearest < MinDistance * MinDistance;
        }

        bool TryClose(int at, Surfel* near, out Surfel surfel)
        {
            int side = Grid.SideWithMargins, reach = Grid.HoleReach, count = 0, nearest = -1;
            float maxDistanceSq = Grid.HoleVoxels * Grid.HoleVoxels, nearestSq = maxDistanceSq / 4;
            var surfelOf = (int*)Memory.SurfelOf.GetUnsafePtr();
            var surfels = Memory.Surfels.GetUnsafePtr();
            surfel = default;
            for (int z = -reach; z <= reach; z++)
                for (int y = -reach; y <= reach; y++)
                {
                    var row = surfelOf + at + side * (y + side * z);
                    for (int x = -reach; x <= reach && count < MaxNear; x++)
                    {
                        int number = row[x];
                        if (number <= 0 || number > Measured)
                            continue;
                        var offset = surfels[number - 1].Position + new float3(x, y, z) - 0.5f;
                        float distanceSq = math.lengthsq(offset);
                        if (distanceSq > maxDistanceSq)
                            continue;
                        if (distanceSq < nearestSq)
                        {
                            nearestSq = distanceSq;
                            nearest = count;
                        }
                        near[count++] = new Surfel { Position = offset, Normal = surfels[number - 1].Normal };
                    }
                }
            if (nearest < 0 || nearestSq < MinDistance * MinDistance)
                return false;
            return IsBetween(near, count, near[nearest], maxDistanceSq, out surfel);
        }

        static bool IsBetween(Surfel* near, int count, in Surfel reference, float maxDistanceSq, out Surfel surfel)
        {
            float3 normal = default, mean = default;
            float weights = 0;
            int members = 0;
            for (int i = 0; i < count; i++)
            {
                if (!IsOfPlane(near[i], reference))
                    continue;
                members++;
                float weight = 1.01f - math.lengthsq(near[i].Position) / maxDistanceSq;
                weights += weight;
                mean += weight * near[i].Position;
                normal += weight * (math.dot(near[i].Normal, reference.Normal) < 0 ? -near[i].Normal : near[i].Normal);
            }
            normal = math.normalize(normal);
            float height = math.dot(normal, mean) / weights;
            surfel = new Surfel { Position = 0.5f + normal * height, Normal = normal };
            // Most are of a plane, unless these are leaves.
            if (math.abs(height) > MaxHeight || 2 * members < count)
                return false;
            var right = math.normalize(math.abs(normal.x) < 0.6f ? new float3(0, normal.z, -normal.y)
                : new float3(-normal.z, 0, normal.x));
            var other = math.cross(normal, right);
            uint seen = 0;
            for (int i = 0; i < count; i++)
                if (IsOfPlane(near[i], reference))
                    seen |= 1u << SectorOf(math.dot(near[i].Position, right), math.dot(near[i].Position, other));
            return !HasWideGap(seen);
        }

        static bool IsOfPlane(in Surfel surfel, in Surfel reference) =>
            math.abs(math.dot(surfel.Normal, reference.Normal)) >= MinCosine &&
            math.abs(math.dot(surfel.Position - reference.Position, reference.Normal)) <= MaxOffPlane;

        /// <summary>Of 16, by comparisons alone: eighths of a circle, each cut at half its slope.</summary>
        static int SectorOf(float x, float y)
        {
            float a = math.abs(x), b = math.abs(y);
            int sector = b < a ? (b * 2.4142136f < a ? 0 : 1) : a * 2.4142136f < b ? 3 : 2;
            sector = x < 0 ? 7 - sector : sector;
            return y < 0 ? Sectors - 1 - sector : sector;
        }

        static bool HasWideGap(uint seen)
        {
            uint empty = ~seen & ((1u << Sectors) - 1);
            uint circle = empty | empty << Sectors, run = circle;
            for (int i = 0; i < MaxEmptySectors; i++)
                run &= circle >> (i + 1);
            return (run & ((1u << Sectors) - 1)) != 0;
        }
    }
}
