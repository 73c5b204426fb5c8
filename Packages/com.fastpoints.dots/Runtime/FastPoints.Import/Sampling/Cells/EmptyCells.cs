using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Tracks which cubic cells of space hold a point, by their hash. Blittable, for jobs.</summary>
    /// <remarks>Two cells may share a bit: with a million occupied ones, 3 % of cells count as occupied too soon.</remarks>
    internal struct EmptyCells
    {
        const int BitsLog2 = 25;

        /// <summary>Words of the table: 4 MiB.</summary>
        public const int Words = 1 << BitsLog2 - 6;

        public double3 Corner;
        public double CellsPerUnit;

        /// <summary>Marks the cell of a position.</summary>
        /// <returns>Whether it was empty.</returns>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public unsafe bool Mark(ulong* table, double x, double y, double z)
        {
            // Far away everything is one cell: a conversion that overflows always gives the same value.
            long cellX = (long)math.floor((x - Corner.x) * CellsPerUnit);
            long cellY = (long)math.floor((y - Corner.y) * CellsPerUnit);
            long cellZ = (long)math.floor((z - Corner.z) * CellsPerUnit);
            ulong hash = ((ulong)cellX * 0x9E3779B97F4A7C15UL ^ (ulong)cellY) * 0xBF58476D1CE4E5B9UL;
            hash = (hash ^ hash >> 32 ^ (ulong)cellZ) * 0x94D049BB133111EBUL;
            hash = (hash ^ hash >> 29) * 0x9E3779B97F4A7C15UL >> 64 - BitsLog2;
            ulong bit = 1UL << (int)(hash & 63);
            bool isBare = (table[hash >> 6] & bit) == 0;
            table[hash >> 6] |= bit;
            return isBare;
        }
    }
}
