using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>Finds distances to nearest neighbours up to a limit, with a hash grid whose cells are as large.</summary>
    internal unsafe struct NearestNeighbours
    {
        readonly double3* m_points;
        readonly int m_bits;
        readonly int* m_first;
        readonly int* m_next;
        readonly double m_limit;
        readonly double m_perCell;

        /// <param name="scratch"><see cref="ClosestPair.ScratchOf"/> entries; the first <see cref="Cells"/> are to be cleared to
        /// -1 before points are added.</param>
        public NearestNeighbours(double3* points, int count, double limit, int* scratch)
        {
            m_points = points;
            m_bits = 64 - math.lzcnt((ulong)count);
            m_first = scratch;
            m_next = scratch + (1 << m_bits);
            m_limit = limit;
            m_perCell = 1 / limit;
        }

        public static int Cells(int count) => 1 << 64 - math.lzcnt((ulong)count);

        public void Clear(int begin, int end) => UnsafeUtility.MemSet(m_first + begin, 0xFF, (long)sizeof(int) * (end - begin));

        public void Add(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                int slot = ClosestPair.Slot(math.floor(m_points[i] * m_perCell), m_bits);
                m_next[i] = m_first[slot];
                m_first[slot] = i;
            }
        }

        /// <summary>A point's distance to its nearest neighbour, after all were added; infinity if there is none within the
        /// limit.</summary>
        public double DistanceOf(int point)
        {
            double nearestSq = m_limit * m_limit;
            bool isFound = false;
            var cell = math.floor(m_points[point] * m_perCell);
            for (int n = 0; n < 27 && nearestSq > 0; n++)
            {
                int slot = ClosestPair.Slot(cell + new double3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1), m_bits);
                for (int other = m_first[slot]; other >= 0 && nearestSq > 0; other = m_next[other])
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
    }
}
