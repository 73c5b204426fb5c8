using System.Runtime.CompilerServices;

namespace FastPoints.Queries
{
    // The first hits of a query so far, in memory of the caller's: the last of them is on top.
    internal unsafe struct HitHeap
    {
        readonly PickHit* m_items;
        readonly int m_capacity;
        readonly PickHit m_bound; // A hit must come before it.
        readonly bool m_countsAll;

        public HitHeap(PickHit* items, int capacity, bool countsAll, in PickHit bound)
        {
            m_items = items;
            m_capacity = capacity;
            m_countsAll = countsAll;
            m_bound = bound;
            Totals = default;
        }

        public HitTotals Totals;

        public readonly PickHit this[int index] => m_items[index];

        // What is farther need not be looked at.
        public readonly double Limit
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => m_countsAll ? double.PositiveInfinity : m_capacity == 0 ? 0
                : Totals.Count < m_capacity ? m_bound.Distance : m_items[0].Distance;
        }

        // The hit that others must come before.
        public readonly PickHit Last =>
            m_capacity == 0 ? default : Totals.Count < m_capacity ? m_bound : m_items[0];

        public void Add(in PickHit hit)
        {
            Totals.Matches++;
            Keep(hit);
        }

        public void Add(PickHit* kept, in HitTotals totals)
        {
            Totals.Matches += totals.Matches;
            for (int i = 0; i < totals.Count; i++)
                Keep(kept[i]);
        }

        // First hit first. It is no heap afterwards.
        public readonly void Sort()
        {
            for (int end = Totals.Count - 1; end > 0; end--)
            {
                var last = m_items[0];
                Sink(m_items[end], end);
                m_items[end] = last;
            }
        }

        void Keep(in PickHit hit)
        {
            if (m_capacity == 0 || !hit.IsBefore(Last))
                return;
            if (Totals.Count == m_capacity)
            {
                Sink(hit, m_capacity);
                return;
            }
            int at = Totals.Count++;
            for (int parent; at > 0 && m_items[parent = (at - 1) >> 1].IsBefore(hit); at = parent)
                m_items[at] = m_items[parent];
            m_items[at] = hit;
        }

        // In place of the one on top of so many.
        readonly void Sink(in PickHit hit, int count)
        {
            int at = 0;
            for (int child; (child = 2 * at + 1) < count; at = child)
            {
                if (child + 1 < count && m_items[child].IsBefore(m_items[child + 1]))
                    child++;
                if (!hit.IsBefore(m_items[child]))
                    break;
                m_items[at] = m_items[child];
            }
            m_items[at] = hit;
        }
    }

    internal struct HitTotals
    {
        public int Count; // Of hits that were kept.
        public long Matches; // Points that were asked for: of those that were looked at, if not all are counted.
    }

    internal struct PickHit
    {
        public double Distance; // World units along the ray, or from the centre; infinity if nothing was found.
        public double RayDistanceSq;
        public Grid3 Position; // On the cloud's grid.
        public int Cloud;
        public int Page;
        public int Node; // Its planes hold the point.
        public int Block;
        public int Index; // In its block.
        public ushort Normal; // OctahedralNormal, of a stored point.

        public static PickHit None => new PickHit { Distance = double.PositiveInfinity };

        public readonly bool IsFound => Distance < double.PositiveInfinity;

        // Nearer to the camera, or, at equal distance, nearer to the ray. Ties are decided by position, so that no reading
        // order matters; of several points at one position, the first one wins.
        public readonly bool IsBefore(in PickHit other)
        {
            if (Distance != other.Distance)
                return Distance < other.Distance;
            if (RayDistanceSq != other.RayDistanceSq)
                return RayDistanceSq < other.RayDistanceSq;
            if (Position.X != other.Position.X)
                return Position.X < other.Position.X;
            if (Position.Y != other.Position.Y)
                return Position.Y < other.Position.Y;
            if (Position.Z != other.Position.Z)
                return Position.Z < other.Position.Z;
            if (Cloud != other.Cloud)
                return Cloud < other.Cloud;
            if (Page != other.Page)
                return Page < other.Page;
            return Node != other.Node ? Node < other.Node : Block != other.Block ? Block < other.Block : Index < other.Index;
        }
    }
}
