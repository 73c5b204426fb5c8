using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>The order in which points are tried. Only the share of points with a higher priority matters, so priorities are
    /// classed by its magnitude: the exponent and two bits below it. Points of one class follow the Morton curve, which keeps the
    /// hash grid's neighbourhood in the cache; by chance alone, at least four times as many points come before each
    /// class.</summary>
    internal static class PoissonPriority
    {
        const int Octaves = 16;

        public const int Classes = 4 * Octaves + 1;

        /// <summary>And once more for points beside the faces of their chunk, which come last.</summary>
        public const int ClassesWithFaces = 2 * Classes;

        /// <summary>The class of a record's hash: 0 is tried first and has 2^-16 of the points.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int ClassOf(uint priority)
        {
            uint rank = ~priority;
            int zeros = math.lzcnt(rank);
            if (zeros >= Octaves)
                return 0;
            return (Octaves - 1 - zeros) * 4 + (int)(rank >> (29 - zeros) & 3) + 1;
        }
    }
}
