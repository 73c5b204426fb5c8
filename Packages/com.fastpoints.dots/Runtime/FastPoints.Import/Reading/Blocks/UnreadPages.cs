using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    /// <summary>Pages of an octree's hierarchy that are known but not read, by the level of the nodes that they begin with, and
    /// within a level in the order of discovery.</summary>
    internal sealed class UnreadPages
    {
        readonly Queue<UnreadPage>[] m_ofLevel;

        /// <summary>Numbers of pages that were read out of turn and are still in the queues.</summary>
        readonly HashSet<int> m_isRead = new HashSet<int>();
        int m_added;

        /// <param name="maxLevels">The most levels of nodes that pages begin with.</param>
        public UnreadPages(int maxLevels)
        {
            m_ofLevel = new Queue<UnreadPage>[maxLevels];
            for (int level = 0; level < maxLevels; level++)
                m_ofLevel[level] = new Queue<UnreadPage>();
        }

        public int Count { get; private set; }

        /// <param name="root">Key of the node that the page begins with.</param>
        public void Add(int4 root, long offset = 0, long bytes = 0)
        {
            var page = new UnreadPage { Root = root, Offset = offset, Bytes = bytes, Number = m_added++ };
            m_ofLevel[root.w].Enqueue(page);
            Count++;
        }

        /// <summary>Finds the next page that a node, those above and those below it need.</summary>
        /// <param name="node">The node's key; the root's for all pages, which takes no time.</param>
        /// <param name="levels">Pages that begin below this many levels of the tree are ignored.</param>
        /// <returns>Whether there is one.</returns>
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

        /// <summary>Records that a page has been read.</summary>
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

        /// <summary>Whether one node is the other, or is above or below it.</summary>
        static bool IsAlong(int4 a, int4 b)
        {
            int level = math.min(a.w, b.w);
            return math.all(a.xyz >> (a.w - level) == b.xyz >> (b.w - level));
        }
    }

    /// <summary>A page of an octree's hierarchy that is known but not read.</summary>
    internal struct UnreadPage
    {
        /// <summary>Key of the node that it begins with.</summary>
        public int4 Root;

        /// <summary>Its location in its file; 0 if it is a file of its own.</summary>
        public long Offset;
        public long Bytes;

        /// <summary>Rises from page to page.</summary>
        public int Number;
    }
}
