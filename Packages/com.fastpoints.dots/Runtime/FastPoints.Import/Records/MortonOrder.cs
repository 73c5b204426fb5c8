using System.Runtime.CompilerServices;
using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Records
{
    /// <summary>The order along the Morton curve of places of any size, without making their codes. Coordinates are not
    /// negative.</summary>
    internal static class MortonOrder
    {
        /// <summary>Negative where a comes first, 0 at one place.</summary>
        public static int Compare(Grid3 a, Grid3 b)
        {
            ulong x = (ulong)(a.X ^ b.X), y = (ulong)(a.Y ^ b.Y), z = (ulong)(a.Z ^ b.Z);
            // The axis with the highest differing bit decides; at one level z counts more than y, y more than x.
            if (IsHigher(x, y))
                return IsHigher(x, z) ? Compare(a.X, b.X) : Compare(a.Z, b.Z);
            return IsHigher(y, z) ? Compare(a.Y, b.Y) : Compare(a.Z, b.Z);
        }

        static int Compare(long a, long b) => a < b ? -1 : a > b ? 1 : 0;

        /// <summary>log2 of the side of the smallest cube of the octree that has both places.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int CommonCubeLog2(Grid3 a, Grid3 b) =>
            64 - math.lzcnt((ulong)(a.X ^ b.X | a.Y ^ b.Y | a.Z ^ b.Z));

        /// <summary>Whether a's highest bit is above b's.</summary>
        static bool IsHigher(ulong a, ulong b) => a > b && (a ^ b) > b;
    }
}
