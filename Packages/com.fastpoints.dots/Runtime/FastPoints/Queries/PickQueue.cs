using System.Collections.Generic;

namespace FastPoints.Queries
{
    // The candidates of a search, nearest first: a binary heap that keeps its memory.
    sealed class PickQueue
    {
        readonly List<PickCandidate> m_items = new List<PickCandidate>();

        public int Count => m_items.Count;

        public PickCandidate Next => m_items[0];

        public void Clear() => m_items.Clear();

        public void Push(in PickCandidate item)
        {
            int at = m_items.Count;
            m_items.Add(item);
            for (int parent; at > 0 && item.IsBefore(m_items[parent = (at - 1) >> 1]); at = parent)
                m_items[at] = m_items[parent];
            m_items[at] = item;
        }

        public PickCandidate Pop()
        {
            int count = m_items.Count - 1;
            PickCandidate best = m_items[0], last = m_items[count];
            m_items.RemoveAt(count);
            if (count == 0)
                return best;
            int at = 0;
            for (int child; (child = 2 * at + 1) < count; at = child)
            {
                if (child + 1 < count && m_items[child + 1].IsBefore(m_items[child]))
                    child++;
                if (!m_items[child].IsBefore(last))
                    break;
                m_items[at] = m_items[child];
            }
            m_items[at] = last;
            return best;
        }
    }

    // A node, or a page that is not loaded, in which a ray might hit something.
    struct PickCandidate
    {
        public const int WholePage = -1;
        public double Distance; // Along the ray: no hit in it or below it is nearer.
        public int Page;
        public int Node;
        public double SpacingAbove; // Of the points above it, in CRS units.

        public readonly bool IsPage => Node == WholePage;

        public readonly bool IsBefore(in PickCandidate other) => Distance != other.Distance ? Distance < other.Distance
            : Page != other.Page ? Page < other.Page : Node < other.Node;
    }
}
