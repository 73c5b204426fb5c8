using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Verify
{
    /// <summary>Finds the smallest distance between any two points with a hash grid whose cells are as large as the closest
    /// neighbours in the order of the points, so that few points share a cell (Rabin 1976).</summary>
    internal static unsafe class ClosestPair
    {
        /// <summary>The distance; infinity for fewer than two points.</summary>
        public static double Distance(double3* points, int count)
        {
            double bestSq = double.PositiveInfinity;
            for (int i = 1; i < count; i++)
                bestSq = math.min(bestSq, math.distancesq(points[i - 1], points[i]));
            if (count < 3 || bestSq == 0 || double.IsInfinity(bestSq))
                return math.sqrt(bestSq);

            int bits = 64 - math.lzcnt((ulong)count);
            int* first = (int*)UnsafeUtility.Malloc((long)sizeof(int) << bits, 16, Allocator.Temp);
            int* next = (int*)UnsafeUtility.Malloc((long)sizeof(int) * count, 16, Allocator.Temp);
            for (int i = 0; i < 1 << bits; i++)
                first[i] = -1;
            double perCell = 1 / math.sqrt(bestSq);
            for (int i = 0; i < count && bestSq > 0; i++)
            {
                var cell = math.floor(points[i] * perCell);
                for (int n = 0; n < 27; n++)
                {
                    var neighbour = cell + new double3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
                    for (int other = first[Slot(neighbour, bits)]; other >= 0; other = next[other])
                        bestSq = math.min(bestSq, math.distancesq(points[i], points[other]));
                }
                int slot = Slot(cell, bits);
                next[i] = first[slot];
                first[slot] = i;
            }
            UnsafeUtility.Free(next, Allocator.Temp);
            UnsafeUtility.Free(first, Allocator.Temp);
            return math.sqrt(bestSq);
        }

        internal static int Slot(double3 cell, int bits)
        {
            ulong hash = (ulong)(long)cell.x * 0x9E3779B97F4A7C15UL ^ (ulong)(long)cell.y * 0xC2B2AE3D27D4EB4FUL ^
                (ulong)(long)cell.z * 0x165667B19E3779F9UL;
            return (int)(hash * 0x9E3779B97F4A7C15UL >> (64 - bits));
        }
    }
}
