using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>Chooses the nodes of some clouds that some views need most: those whose parents' points lie farthest apart on a
    /// screen first, until one budget of points for all clouds is used up. A parent always comes before its children. It examines
    /// only what it chooses and the children of that, however large the clouds are.</summary>
    [BurstCompile]
    internal unsafe struct SelectNodesJob : IJob
    {
        const float LightShare = 0.2f; // Of the budget, what is chosen for lights alone.

        [ReadOnly] public NativeArray<SelectionCloud> Clouds;
        [ReadOnly] public NativeArray<CloudView> Views; // Indexed by cloud times ViewCount, plus view.
        public int ViewCount;
        [ReadOnly] public NativeArray<LocalClip> Clips; // Indexed by cloud times ClipCount, plus clip box.
        public int ClipCount;
        public LodSettings Settings;
        public uint Frame; // See LodSelector.Frame.

        /// <summary>Whether it chooses for future views, on top of what this frame's selection chose, without changing any node's
        /// state.</summary>
        public bool IsPrefetch;
        public long PrefetchPoints; // A prefetch ends after this many points that were not chosen before.

        /// <summary>Ends the choice when this many pages are missing; what was chosen until then is the start of the full
        /// choice.</summary>
        public int MissingToStopAt;

        public SelectionHeap Heap;
        public NativeList<SelectedNode> Selected;
        public NativeList<MissingHierarchyPage> Missing;
        public NativeReference<long> Points;

        public void Execute()
        {
            Heap.Clear();
            Selected.Clear();
            Missing.Clear();
            for (int c = 0; c < Clouds.Length; c++)
                if (Clouds[c].Pages[0].IsLoaded && Clouds[c].Pages[0].NodeCount > 0 && IsShown(c))
                    Heap.Push(new SelectionCandidate { ScreenErrorPx = float.MaxValue, CloudIndex = c, Parent = -1 });
            long points = 0, more = 0, pointsForLight = 0;
            while (!Heap.IsEmpty)
            {
                var best = Heap.Pop();
                var cloud = Clouds[best.CloudIndex];
                var page = cloud.Pages + best.Page;
                if (best.Node < 0)
                {
                    Missing.Add(new MissingHierarchyPage { Cloud = cloud.Cloud, Page = best.Page });
                    if (Missing.Length >= MissingToStopAt)
                        break;
                    continue;
                }
                var node = page->Nodes + best.Node;
                int cost = page->IsHole(best.Node) || cloud.IsReplacement ? 0 : node->PointCount;
                if (points > 0 && points + cost > Settings.PointBudget)
                    break;
                if (best.IsForLight && (pointsForLight += cost) > Settings.PointBudget * LightShare)
                {
                    pointsForLight -= cost;
                    continue;
                }
                points += cost;
                int index = Select(best, cloud, page, ref more);
                if (IsPrefetch && more >= PrefetchPoints)
                    break;
                for (int i = 0; i < node->ChildCount; i++)
                    PushNode(best.CloudIndex, page, best.Page, node->FirstChild + i, node->Spacing, index);
                for (int i = 0; i < node->PageCount; i++)
                    PushPage(best.CloudIndex, cloud.Pages, node->FirstPage + i, node->Spacing, index);
            }
            Points.Value = points;
        }

        bool IsShown(int cloud)
        {
            bool isShown = ViewCount == 0;
            for (int v = 0; v < ViewCount; v++)
                isShown |= Views[cloud * ViewCount + v].IsShown;
            return isShown;
        }

        int Select(in SelectionCandidate best, in SelectionCloud cloud, HierarchyPage* page, ref long more)
        {
            var state = page->States + best.Node;
            if (IsPrefetch)
            {
                if (state->SelectedFrame == Frame)
                    return -1;
                more += page->Nodes[best.Node].PointCount;
            }
            else
            {
                state->VisitedFrame = Frame;
                state->SelectedFrame = Frame;
            }
            Selected.Add(new SelectedNode { Cloud = cloud.Cloud, Page = best.Page, Node = best.Node, Parent = best.Parent });
            return Selected.Length - 1;
        }

        void PushNode(int cloud, HierarchyPage* page, int pageIndex, int index, float spacing, int parent)
        {
            var node = page->Nodes + index;
            if (node->PointCount == 0 ||
                !TryGetScreenError(cloud, node->Center, node->Half, spacing, out float screenErrorPx, out bool isForLight))
                return;
            var state = page->States + index;
            // The selection before this one stamped it, or this frame's if this is a prefetch.
            if (Frame - state->SelectedFrame <= 1)
                screenErrorPx *= Settings.Hysteresis;
            if (!IsPrefetch)
            {
                if (Frame - state->VisitedFrame > 1)
                    state->InViewSinceFrame = Frame;
                state->VisitedFrame = Frame;
            }
            if (screenErrorPx >= Settings.MinScreenErrorPx)
                Heap.Push(new SelectionCandidate
                {
                    ScreenErrorPx = screenErrorPx,
                    CloudIndex = cloud,
                    Page = pageIndex,
                    Node = index,
                    Parent = parent,
                    IsForLight = isForLight,
                });
        }

        void PushPage(int cloud, HierarchyPage* pages, int index, float spacing, int parent)
        {
            var page = pages + index;
            if (!TryGetScreenError(cloud, page->Center, page->Half, spacing, out float screenErrorPx, out _))
                return;
            page->VisitedFrame = Frame;
            if (page->IsLoaded)
            {
                for (int n = 0; n < page->RootCount; n++)
                    PushNode(cloud, page, index, n, spacing, parent);
            }
            else if (page->Status != HierarchyPageStatus.Failed && screenErrorPx >= Settings.MinScreenErrorPx)
                Heap.Push(new SelectionCandidate { ScreenErrorPx = screenErrorPx, CloudIndex = cloud, Page = index, Node = -1 });
        }

        // Returns the spacing in the camera that shows it largest; if none does, in such a light.
        bool TryGetScreenError(int cloud, double3 center, double3 half, float spacing, out float screenErrorPx,
            out bool isForLight)
        {
            screenErrorPx = 0;
            isForLight = true;
            if (ClipCount > 0 &&
                !LocalClip.MayKeep((LocalClip*)Clips.GetUnsafeReadOnlyPtr() + cloud * ClipCount, ClipCount, center, half))
                return false;
            var views = (CloudView*)Views.GetUnsafeReadOnlyPtr() + cloud * ViewCount;
            for (int v = 0; v < ViewCount; v++)
            {
                // Cameras come before lights.
                if (views[v].IsLight && !isForLight)
                    break;
                if (!views[v].IntersectsFrustum(center, half))
                    continue;
                isForLight &= views[v].IsLight;
                double distance = views[v].DistanceTo(center, half);
                double size = 2 * math.length(half * views[v].AxisScale);
                // A box without extent, with one point or many at one place, counts as large as the gap that it fills.
                size = math.max(size, spacing * views[v].SpacingScale);
                if (views[v].LengthPx(size, distance) >= Settings.MinNodePx)
                    screenErrorPx = math.max(screenErrorPx, (float)views[v].LengthPx(spacing * views[v].SpacingScale, distance));
            }
            return screenErrorPx > 0;
        }
    }

    /// <summary>A node that was chosen: parents before children, the most needed first.</summary>
    internal struct SelectedNode
    {
        public int Cloud;
        public int Page;
        public int Node;
        public int Parent; // Index of its parent among the chosen nodes; -1 for a root.
    }

    internal unsafe struct SelectionCloud
    {
        public HierarchyPage* Pages; // All pages known so far.
        public int Cloud;
        public bool IsReplacement;
        public double3 CubeSize; // Size of the root cube, in units of each axis.
    }
}
