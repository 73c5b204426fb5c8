using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Store
{
    // Maps grid positions to a cloud's own space: CRS units from the corner of the root cube.
    internal struct HierarchyGrid
    {
        public Grid3 Corner;
        public double3 Step;
        public int RootSideLog2;
        public Grid3 BoundsMin;
        public Grid3 BoundsMax;

        public HierarchyGrid(CloudManifest manifest)
        {
            Corner = manifest.Root.Corner;
            Step = manifest.Grid.Step;
            RootSideLog2 = manifest.Root.SideLog2;
            BoundsMin = manifest.BoundsMin;
            BoundsMax = manifest.BoundsMax;
        }

        public double3 ToLocal(Grid3 place)
        {
            var from = place - Corner;
            return new double3(from.X, from.Y, from.Z) * Step;
        }

        // Both ends are included; rounded outwards.
        public void Box(Grid3 min, Grid3 max, out double3 center, out float3 half) =>
            Box(ToLocal(min), ToLocal(max), out center, out half);

        public static void Box(double3 min, double3 max, out double3 center, out float3 half)
        {
            center = (min + max) * 0.5;
            // The last digit of a float is 1.2e-7 of its value; the centre's rounding in double is far smaller.
            half = (float3)((max - min) * (0.5 * (1 + 2.4e-7)));
        }
    }
}
