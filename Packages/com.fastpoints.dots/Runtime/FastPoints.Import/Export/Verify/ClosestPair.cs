using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>Finds the smallest distance between any two points with a hash grid whose cells are as large as the closest
    /// neighbours in the order of the points, so that few points share a cell (Rabin 1976). It works in slices.</summary>
    internal unsafe struct ClosestPair
    {
        /// <summary>Work that a slice counts for one point of the grid; comparing neighbours and clearing take less.</summary>
        const int ComparedPerUnit = 32, ClearedPerUnit = 512;

        /// <summary>Points to find the closest two of.</summary>
        readonly int m_count;
        readonly int m_bits;
        int m_compared;
        int m_cleared;
        int m_added;
        double m_bestSq;
        double m_perCell;

        public ClosestPair(int count) : this()
        {
            m_count = count;
            m_bits = 64 - math.lzcnt((ulong)count);
            m_compared = 1;
            m_bestSq = double.PositiveInfinity;
        }

        /// <summary>The distance, when it is done; infinity for fewer than two points.</summary>
        public double Distance => math.sqrt(m_bestSq);

        /// <summary>Entries of scratch memory for so many points.</summary>
        public static long ScratchOf(int count) => (1L << 64 - math.lzcnt((ulong)count)) + count;

        /// <summary>The most work that so many points are.</summary>
        public static long UnitsOf(int count) => 4 + count + count / ComparedPerUnit + ScratchOf(count) / ClearedPerUnit;

        /// <summary>Continues.</summary>
        /// <param name="scratch">The same each time: <see cref="ScratchOf"/> entries.</param>
        /// <param name="units">Work that is left to the slice; what is done is taken off.</param>
        /// <returns>Whether it is done.</returns>
        public bool Step(double3* points, int* scratch, ref long units)
        {
            int end = (int)math.min(m_count, m_compared + units * ComparedPerUnit);
            for (int i = m_compared; i < end; i++)
                m_bestSq = math.min(m_bestSq, math.distancesq(points[i - 1], points[i]));
            units -= math.max(0, end - m_compared) / ComparedPerUnit + 1;
            m_compared = math.max(m_compared, end);
            if (m_compared < m_count)
                return false;
            if (m_count < 3 || m_bestSq == 0 || double.IsInfinity(m_bestSq))
                return true;

            int* next = scratch + (1 << m_bits);
            if (m_cleared < 1 << m_bits)
            {
                end = (int)math.min(1 << m_bits, m_cleared + math.max(0, units) * ClearedPerUnit);
                UnsafeUtility.MemSet(scratch + m_cleared, 0xFF, (long)sizeof(int) * (end - m_cleared));
                units -= (end - m_cleared) / ClearedPerUnit + 1;
                m_cleared = end;
                m_perCell = 1 / math.sqrt(m_bestSq);
                if (m_cleared < 1 << m_bits)
                    return false;
            }
            for (; m_added < m_count && m_bestSq > 0; m_added++, units--)
            {
                if (units <= 0)
                    return false;
                Add(points, scratch, next);
            }
            return true;
        }

        void Add(double3* points, int* first, int* next)
        {
            var cell = math.floor(points[m_added] * m_perCell);
            for (int n = 0; n < 27; n++)
            {
                var neighbour = cell + new double3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
                for (int other = first[Slot(neighbour, m_bits)]; other >= 0; other = next[other])
                    m_bestSq = math.min(m_bestSq, math.distancesq(points[m_added], points[other]));
            }
            int slot = Slot(cell, m_bits);
            next[m_added] = first[slot];
            first[slot] = m_added;
        }

        internal static int Slot(double3 cell, int bits)
        {
            ulong hash = (ulong)(long)cell.x * 0x9E3779B97F4A7C15UL ^ (ulong)(long)cell.y * 0xC2B2AE3D27D4EB4FUL ^
                (ulong)(long)cell.z * 0x165667B19E3779F9UL;
            return (int)(hash * 0x9E3779B97F4A7C15UL >> (64 - bits));
        }
    }
}
