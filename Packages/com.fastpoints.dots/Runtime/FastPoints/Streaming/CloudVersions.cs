using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>One cloud in several states, each better than the one before: waves of a preview, generations of a build, the
    /// finished cloud. A newer state is streamed beside the shown one and replaces it when nearly all of its selected nodes are
    /// loaded. A preview stays beside a build in progress, whose unfinished regions have fewer points, until the whole cloud
    /// replaces both: each region only ever gains. Main thread.</summary>
    internal sealed class CloudVersions
    {
        public const int None = -1;
        const double ReadyShare = 0.95; // The older state goes when this share of the newer one's selected nodes is drawn.

        readonly StreamContext m_stream;
        CloudStage m_stage;
        CloudStage m_nextStage;
        uint m_frameAdded;

        public CloudVersions(StreamContext stream) => m_stream = stream;

        public int ShownNumber { get; private set; } = None; // Number of the state that is shown; None before the first one.

        /// <summary>Number of the preview that is shown beside a build in progress, or <see cref="None"/>.</summary>
        public int Preview { get; private set; } = None;

        public int Next { get; private set; } = None; // Number of the next state to show, or None.

        public bool IsCurrent => Next == None;

        /// <summary>Adds a newer state, which the stream owns. An earlier one that is not shown yet is dropped.</summary>
        public void Add(NodeSource source, CloudPlacement? placement = null, CloudStage stage = CloudStage.Whole)
        {
            int added = m_stream.Add(source, placement ?? PlacementFor(source));
            m_frameAdded = m_stream.Selector.Frame;
            if (ShownNumber == None)
            {
                ShownNumber = added;
                m_stage = stage;
                return;
            }
            if (Next != None)
                m_stream.Remove(Next);
            Next = added;
            m_stream.Clouds[added].IsReplacement = source.HasNodesOf(m_stream.Clouds[ShownNumber].Source);
            m_nextStage = stage;
        }

        /// <summary>Moves all states in the stream: the placement is the shown one's.</summary>
        public void Place(in CloudPlacement placement)
        {
            var shown = m_stream.Clouds[ShownNumber];
            shown.Placement = placement;
            if (Preview != None)
                m_stream.Clouds[Preview].Placement = placement.ForVersion(shown.Source, m_stream.Clouds[Preview].Source);
            if (Next != None)
                m_stream.Clouds[Next].Placement = placement.ForVersion(shown.Source, m_stream.Clouds[Next].Source);
        }

        /// <summary>Updates the states once after each frame. Returns whether <see cref="ShownNumber"/> has changed.</summary>
        public bool Update()
        {
            if (Next == None || !IsReady(Next))
                return false;
            int next = Next;
            Next = None;
            if (m_nextStage == CloudStage.Preview && m_stage == CloudStage.Building)
            {
                Remove(Preview);
                Preview = next;
                return false;
            }
            if (m_nextStage == CloudStage.Building && m_stage == CloudStage.Preview)
            {
                Preview = ShownNumber;
            }
            else
            {
                m_stream.Remove(ShownNumber);
                if (m_nextStage != CloudStage.Building)
                {
                    Remove(Preview);
                    Preview = None;
                }
            }
            ShownNumber = next;
            m_stream.Clouds[next].IsReplacement = false;
            m_stage = m_nextStage;
            return true;
        }

        /// <summary>Removes a build that was aborted. Returns whether <see cref="ShownNumber"/> has changed.</summary>
        public bool DropBuild()
        {
            if (Next != None && m_nextStage == CloudStage.Building)
            {
                m_stream.Remove(Next);
                Next = None;
            }
            if (ShownNumber == None || m_stage != CloudStage.Building)
                return false;
            m_stage = CloudStage.Preview;
            if (Preview == None)
                return false;
            m_stream.Remove(ShownNumber);
            ShownNumber = Preview;
            Preview = None;
            return true;
        }

        internal void Remove()
        {
            Remove(ShownNumber);
            Remove(Preview);
            Remove(Next);
            ShownNumber = Preview = Next = None;
        }

        void Remove(int cloud)
        {
            if (cloud != None)
                m_stream.Remove(cloud);
        }

        CloudPlacement PlacementFor(NodeSource source) => ShownNumber == None
            ? CloudPlacement.Geo(source.Grid, source.Root)
            : m_stream.Clouds[ShownNumber].Placement.ForVersion(m_stream.Clouds[ShownNumber].Source, source);

        unsafe bool HasFailed(SelectedNode node)
        {
            var page = m_stream.Clouds[node.Cloud].Pages + node.Page;
            return page->IsHole(node.Node) && page->Nodes[node.Node].BlockCount > 0;
        }

        bool IsReady(int cloud)
        {
            var selected = m_stream.Selector.Selected;
            int count = 0, shown = 0;
            for (int i = 0; i < math.min(selected.Length, m_stream.DrawnOfSelected.Length); i++)
            {
                if (selected[i].Cloud != cloud)
                    continue;
                count++;
                int drawn = m_stream.DrawnOfSelected[i];
                bool isShown = drawn >= 0 ? m_stream.Drawn[drawn].DrawnFraction == 1 : drawn == StreamContext.NotDrawn;
                shown += isShown && !HasFailed(selected[i]) ? 1 : 0;
            }
            foreach (var missing in m_stream.Selector.Missing)
                if (missing.Cloud == cloud)
                    return false;
            // A cloud out of view has nothing to wait for once a selection has considered it.
            bool isReady = shown >= ReadyShare * count;
            // Where memory does not hold both, the older one gives way.
            isReady |= m_stream.Clouds[cloud].IsReplacement && m_stream.Reads.LacksRoom && m_stream.Reads.InFlightCount == 0;
            return isReady && m_stream.Selector.Frame != m_frameAdded;
        }
    }

    /// <summary>How complete a cloud is that is shown before the whole is ready.</summary>
    public enum CloudStage
    {
        /// <summary>A thinned version of the whole cloud.</summary>
        Preview,
        /// <summary>A build in progress: all points of some regions, few points of the others.</summary>
        Building,
        /// <summary>All points.</summary>
        Whole,
    }
}
