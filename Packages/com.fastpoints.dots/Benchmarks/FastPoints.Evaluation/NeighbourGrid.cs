using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Finds neighbours among points with a hash grid whose cells are as large as the farthest that are of
    /// interest.</summary>
    internal unsafe struct NeighbourGrid
    {
        [NativeDisableUnsafePtrRestriction] readonly double3* m_points;
        readonly int m_bits;
        [NativeDisableUnsafePtrRestriction] readonly int* m_firstOfSlot;
        [NativeDisableUnsafePtrRestriction] readonly int* m_nextOfPoint;
        readonly double m_limit;
        readonly double m_perCell;

        /// <param name="count">Of all points, none of which is in the grid yet.</param>
        /// <param name="scratch"><see cref="ScratchOf"/> entries.</param>
        public NeighbourGrid(double3* points, int count, double limit, int* scratch)
        {
            m_points = points;
            m_bits = BitsFor(count);
            m_firstOfSlot = scratch;
            m_nextOfPoint = scratch + (1 << m_bits);
            m_limit = limit;
            m_perCell = 1 / limit;
            UnsafeUtility.MemSet(scratch, 0xFF, (long)sizeof(int) << m_bits);
        }

        public static int ScratchOf(int count) => checked((1 << BitsFor(count)) + count);

        /// <summary>The smallest distance between any two points; infinity for fewer than two. Cells are as large as the closest
        /// neighbours in the order of the points, so that few points share one (Rabin 1976).</summary>
        public static double ClosestPair(double3* points, int count, int* scratch)
        {
            double best = ClosestInOrder(points, count);
            if (count < 3 || best == 0)
                return best;
            var grid = new NeighbourGrid(points, count, best, scratch);
            for (int i = 0; i < count && best > 0; i++)
            {
                best = math.min(best, grid.DistanceOf(i));
                grid.Add(i, i + 1);
            }
            return best;
        }

        /// <summary>The smallest distance between points that follow one another.</summary>
        public static double ClosestInOrder(double3* points, int count)
        {
            double bestSq = double.PositiveInfinity;
            for (int i = 1; i < count; i++)
                bestSq = math.min(bestSq, math.distancesq(points[i - 1], points[i]));
            return math.sqrt(bestSq);
        }

        public void Add(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                int slot = Slot(math.floor(m_points[i] * m_perCell));
                m_nextOfPoint[i] = m_firstOfSlot[slot];
                m_firstOfSlot[slot] = i;
            }
        }

        /// <summary>A point's distance to its nearest neighbour in the grid; infinity if none is within the limit.</summary>
        public double DistanceOf(int point)
        {
            double nearestSq = m_limit * m_limit;
            bool isFound = false;
            var cell = math.floor(m_points[point] * m_perCell);
            for (int n = 0; n < 27 && nearestSq > 0; n++)
            {
                int slot = Slot(cell + new double3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
                for (int other = m_firstOfSlot[slot]; other >= 0 && nearestSq > 0; other = m_nextOfPoint[other])
                {
                    double distanceSq = math.distancesq(m_points[point], m_points[other]);
                    if (other == point || distanceSq > nearestSq)
                        continue;
                    nearestSq = distanceSq;
                    isFound = true;
                }
            }
            return isFound ? math.sqrt(nearestSq) : double.PositiveInfinity;
        }

        static int BitsFor(int count) => 64 - math.lzcnt((ulong)count);

        int Slot(double3 cell)
        {
            ulong hash = (ulong)(long)cell.x * 0x9E3779B97F4A7C15UL ^ (ulong)(long)cell.y * 0xC2B2AE3D27D4EB4FUL ^
                (ulong)(long)cell.z * 0x165667B19E3779F9UL;
            return (int)(hash * 0x9E3779B97F4A7C15UL >> (64 - m_bits));
        }
    }
}
