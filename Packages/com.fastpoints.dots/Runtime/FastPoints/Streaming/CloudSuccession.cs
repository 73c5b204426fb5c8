namespace FastPoints.Streaming
{
    /// <summary>
    /// One cloud in several states, each better than the one before: waves of a preview, generations of a build, what was built.
    /// A newer state is streamed beside the one that is shown, and takes its place when nearly all that is selected of it is
    /// there. Main thread.
    /// </summary>
    public sealed class CloudSuccession
    {
        public const int None = -1;

        /// <summary>Of the newer state's selected nodes, so many are drawn when the older one goes.</summary>
        const double ReadyShare = 0.95;

        readonly StreamContext m_stream;
        uint m_frameAdded;
        int m_next = None;

        public CloudSuccession(StreamContext stream)
        {
            m_stream = stream;
        }

        /// <summary>Number of the state that is shown; <see cref="None"/> before the first.</summary>
        public int Cloud { get; private set; } = None;

        /// <summary>Whether the newest state is the one that is shown.</summary>
        public bool IsCurrent => m_next == None;

        /// <summary>Adds a newer state. One before it that is not shown yet never is.</summary>
        /// <param name="source">Becomes the stream's.</param>
        /// <param name="placement">Null for georeferenced space.</param>
        public void Add(NodeSource source, CloudPlacement? placement = null)
        {
            int added = m_stream.Add(source, placement ?? CloudPlacement.Geo(source.Grid, source.Root));
            m_frameAdded = m_stream.Selector.Frame;
            if (Cloud == None)
            {
                Cloud = added;
                return;
            }
            if (m_next != None)
                m_stream.Remove(m_next);
            m_next = added;
        }

        /// <summary>Once a frame, after it.</summary>
        public void Update()
        {
            if (m_next == None || !IsReady(m_next))
                return;
            m_stream.Remove(Cloud);
            Cloud = m_next;
            m_next = None;
        }

        bool IsReady(int cloud)
        {
            int selected = 0, drawn = 0;
            foreach (var node in m_stream.Selector.Selected)
                selected += node.Cloud == cloud ? 1 : 0;
            foreach (var node in m_stream.Drawn)
                drawn += node.Cloud == cloud ? 1 : 0;
            foreach (var missing in m_stream.Selector.Missing)
                if (missing.Cloud == cloud)
                    return false;
            // Out of view there is nothing to wait for, once a selection has had it.
            return drawn >= ReadyShare * selected && m_stream.Selector.Frame != m_frameAdded;
        }
    }
}
