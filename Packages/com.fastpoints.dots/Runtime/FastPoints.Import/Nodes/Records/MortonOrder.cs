using System.Runtime.CompilerServices;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>Compares positions of any size along the Morton curve without making their codes. Coordinates must not be
    /// negative.</summary>
    internal static class MortonOrder
    {
        /// <summary>Negative if a comes first, 0 for equal positions.</summary>
        public static int Compare(Grid3 a, Grid3 b)
        {
            ulong x = (ulong)(a.X ^ b.X), y = (ulong)(a.Y ^ b.Y), z = (ulong)(a.Z ^ b.Z);
            // The axis with the highest differing bit decides; at equal levels z counts more than y, and y more than x.
            if (IsHigher(x, y))
                return IsHigher(x, z) ? Compare(a.X, b.X) : Compare(a.Z, b.Z);
            return IsHigher(y, z) ? Compare(a.Y, b.Y) : Compare(a.Z, b.Z);
        }

        static int Compare(long a, long b) => a < b ? -1 : a > b ? 1 : 0;

        /// <summary>log2 of the side of the smallest cube of the octree with both positions.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int CommonCubeLog2(Grid3 a, Grid3 b) => 64 - math.lzcnt((ulong)(a.X ^ b.X | a.Y ^ b.Y | a.Z ^ b.Z));

        /// <summary>Whether a's highest bit is above b's.</summary>
        static bool IsHigher(ulong a, ulong b) => a > b && (a ^ b) > b;
    }
}
