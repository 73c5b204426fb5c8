using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>Pages of an octree's hierarchy that are known and not read: level by level of the nodes that they begin with, and
    /// within a level as they came to be known.</summary>
    internal sealed class UnreadPages
    {
        readonly Queue<UnreadPage>[] m_ofLevel;

        /// <summary>Numbers of pages that were read before their turn and are in the queues still.</summary>
        readonly HashSet<int> m_isRead = new HashSet<int>();
        int m_added;

        /// <param name="mostLevels">Of the nodes that pages begin with.</param>
        public UnreadPages(int mostLevels)
        {
            m_ofLevel = new Queue<UnreadPage>[mostLevels];
            for (int level = 0; level < mostLevels; level++)
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

        /// <summary>The next page that a node, what is above it and what is below it take.</summary>
        /// <param name="node">Key; the tree's root for pages of the whole, when this takes no time.</param>
        /// <param name="levels">Pages that begin below the first so many levels of the tree are left alone.</param>
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

        /// <summary>Takes note that a page has been read.</summary>
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

    /// <summary>A page of an octree's hierarchy that is known and not read.</summary>
    internal struct UnreadPage
    {
        /// <summary>Key of the node that it begins with.</summary>
        public int4 Root;

        /// <summary>Where it lies in its file; nothing where it is a file of its own.</summary>
        public long Offset;
        public long Bytes;

        /// <summary>Rises from page to page.</summary>
        public int Number;
    }
}
