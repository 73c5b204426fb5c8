using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    // Known pages of an octree's hierarchy, by the level of the nodes that they begin with, in the order of discovery.
    internal sealed class UnreadPages
    {
        readonly Queue<UnreadPage>[] m_ofLevel;

        // Pages that were read out of turn and are still in the queues.
        readonly HashSet<int> m_isRead = new HashSet<int>();
        int m_added;

        public UnreadPages(int maxLevels)
        {
            m_ofLevel = new Queue<UnreadPage>[maxLevels];
            for (int level = 0; level < maxLevels; level++)
                m_ofLevel[level] = new Queue<UnreadPage>();
        }

        public int Count { get; private set; }

        public void Add(int4 root, long offset = 0, long bytes = 0)
        {
            var page = new UnreadPage { Root = root, Offset = offset, Bytes = bytes, Number = m_added++ };
            m_ofLevel[root.w].Enqueue(page);
            Count++;
        }

        // The next page that a node (the root: all pages, at no cost), those above and those below it need; pages that begin
        // below "levels" are ignored.
        public bool TryPeek(int4 node, int levels, out UnreadPage page)
        {
            for (int level = 0; level < math.min(levels, m_ofLevel.Length); level++)
            {
                var pages = m_ofLevel[level];
                while (pages.Count > 0 && m_isRead.Remove(pages.Peek().Number))
                    pages.Dequeue();
                foreach (var waiting in pages)
                {
                    page = waiting;
                    if (IsAlong(waiting.Root, node) && !m_isRead.Contains(waiting.Number))
                        return true;
                }
            }
            page = default;
            return false;
        }

        public void Remove(in UnreadPage page)
        {
            m_isRead.Add(page.Number);
            Count--;
        }

        public void Clear()
        {
            foreach (var pages in m_ofLevel)
                pages.Clear();
            m_isRead.Clear();
            Count = 0;
        }

        // One is the other, or is above or below it.
        static bool IsAlong(int4 a, int4 b)
        {
            int level = math.min(a.w, b.w);
            return math.all(a.xyz >> (a.w - level) == b.xyz >> (b.w - level));
        }
    }

    internal struct UnreadPage
    {
        public int4 Root;

        // 0 if it is a file of its own.
        public long Offset;
        public long Bytes;
        public int Number;
    }
}
