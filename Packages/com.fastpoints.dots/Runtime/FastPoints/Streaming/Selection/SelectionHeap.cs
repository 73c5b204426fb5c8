using System.Runtime.CompilerServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Streaming
{
    // The candidates of a selection, best on top: a binary heap that keeps its memory from frame to frame.
    internal unsafe struct SelectionHeap
    {
        NativeList<SelectionCandidate> m_items;

        public SelectionHeap(Allocator allocator) => m_items = new NativeList<SelectionCandidate>(1024, allocator);

        public bool IsEmpty => m_items.Length == 0;

        public void Clear() => m_items.Clear();

        public void Dispose() => m_items.Dispose();

        public void Push(in SelectionCandidate item)
        {
            m_items.Add(item);
            var items = (SelectionCandidate*)m_items.GetUnsafePtr();
            int at = m_items.Length - 1;
            for (int parent; at > 0 && item.IsBefore(items[parent = (at - 1) >> 1]); at = parent)
                items[at] = items[parent];
            items[at] = item;
        }

        public SelectionCandidate Pop()
        {
            var items = (SelectionCandidate*)m_items.GetUnsafePtr();
            int count = m_items.Length - 1;
            var best = items[0];
            var last = items[count];
            m_items.ResizeUninitialized(count);
            if (count == 0)
                return best;
            int at = 0;
            for (int child; (child = 2 * at + 1) < count; at = child)
            {
                if (child + 1 < count && items[child + 1].IsBefore(items[child]))
                    child++;
                if (!items[child].IsBefore(last))
                    break;
                items[at] = items[child];
            }
            items[at] = last;
            return best;
        }
    }

    internal struct SelectionCandidate
    {
        // Spacing on the screen of the points above: the gaps that the node would fill.
        public float ScreenErrorPx;
        public int CloudIndex;
        public int Page;
        public int Node; // -1 for the page itself.
        public int Parent;
        public bool IsForLight; // No camera sees it.

        // Ties are decided by position, so that a choice can be repeated.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IsBefore(in SelectionCandidate other)
        {
            if (ScreenErrorPx != other.ScreenErrorPx)
                return ScreenErrorPx > other.ScreenErrorPx;
            if (CloudIndex != other.CloudIndex)
                return CloudIndex < other.CloudIndex;
            return Page != other.Page ? Page < other.Page : Node < other.Node;
        }
    }
}
