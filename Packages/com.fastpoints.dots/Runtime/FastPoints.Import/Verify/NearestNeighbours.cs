using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Verify
{
    /// <summary>Finds distances to nearest neighbours up to a limit, with a hash grid whose cells have the limit's
    /// size.</summary>
    internal static unsafe class NearestNeighbours
    {
        // Rounding of double coordinates is far below this; a distance that is exactly the limit is outside it.
        const double Tolerance = 1e-9;

        /// <summary>Counts the points that have another one nearer than the limit.</summary>
        public static long CountWithin(double3* points, int count, double limit)
        {
            var distances = (double*)UnsafeUtility.Malloc((long)math.max(1, count) * sizeof(double), 16, Allocator.Temp);
            Find(points, count, limit, distances);
            long near = 0;
            for (int i = 0; i < count; i++)
                near += distances[i] < limit * (1 - Tolerance) ? 1 : 0;
            UnsafeUtility.Free(distances, Allocator.Temp);
            return near;
        }

        /// <summary>Finds each point's distance to its nearest neighbour; infinity if there is none within the limit.</summary>
        public static void Find(double3* points, int count, double limit, double* distances)
        {
            int bits = 64 - math.lzcnt((ulong)math.max(1, count));
            int* first = (int*)UnsafeUtility.Malloc((long)sizeof(int) << bits, 16, Allocator.Temp);
            int* next = (int*)UnsafeUtility.Malloc((long)sizeof(int) * math.max(1, count), 16, Allocator.Temp);
            UnsafeUtility.MemSet(first, 0xFF, (long)sizeof(int) << bits);
            double perCell = 1 / limit;
            for (int i = 0; i < count; i++)
            {
                int slot = ClosestPair.Slot(math.floor(points[i] * perCell), bits);
                next[i] = first[slot];
                first[slot] = i;
            }
            for (int i = 0; i < count; i++)
            {
                double nearestSq = limit * limit;
                bool isFound = false;
                var cell = math.floor(points[i] * perCell);
                for (int n = 0; n < 27; n++)
                {
                    int slot = ClosestPair.Slot(cell + new double3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1), bits);
                    for (int other = first[slot]; other >= 0; other = next[other])
                    {
                        double distanceSq = math.distancesq(points[i], points[other]);
                        if (other == i || distanceSq > nearestSq)
                            continue;
                        nearestSq = distanceSq;
                        isFound = true;
                    }
                }
                distances[i] = isFound ? math.sqrt(nearestSq) : double.PositiveInfinity;
            }
            UnsafeUtility.Free(next, Allocator.Temp);
            UnsafeUtility.Free(first, Allocator.Temp);
        }
    }
}
