using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    // The jobs of a frame's steps. They run in place, on the main thread: the next step needs their results at once, and to
    // schedule and await a job costs more than any of them.

    // Orders the cache by what a frame has chosen: prefetched nodes go before those that fade out, those before
    // selected ones, and these before pinned ones.
    [BurstCompile]
    internal struct TouchNodesJob : IJob
    {
        const int FadingOutRank = NodeReadQueue.FirstPrefetchRank - 1; // No prefetched node is needed more.

        [ReadOnly] public NativeArray<CloudPages> Clouds;
        [ReadOnly] public NativeArray<DrawnNode> Drawn; // By the last frame; empty if nothing fades.
        [ReadOnly] public NativeArray<SelectedNode> Selected;
        [ReadOnly] public NativeArray<SelectedNode> Prefetched;
        [ReadOnly] public NativeArray<int> Pinned;
        public uint Frame;
        public EvictionOrder Order;

        public void Execute()
        {
            Touch(Prefetched, NodeReadQueue.FirstPrefetchRank);
            for (int i = Drawn.Length - 1; i >= 0; i--)
                if (Order.Nodes[Drawn[i].Slot].DrawnFrame == Frame - 1 && Clouds[Drawn[i].Cloud].IsFadingOut(Drawn, i, Frame))
                    Order.Touch(Drawn[i].Slot, Frame, FadingOutRank);
            Touch(Selected, 0);
            for (int i = 0; i < Pinned.Length; i++)
                Order.Touch(Pinned[i], Frame, -1);
        }

        void Touch(NativeArray<SelectedNode> nodes, int firstRank)
        {
            for (int i = nodes.Length - 1; i >= 0; i--)
            {
                int slot = Clouds[nodes[i].Cloud].StateOf(nodes[i]).Slot;
                if (slot != NodeState.NoSlot)
                    Order.Touch(slot, Frame, firstRank + i);
            }
        }
    }

    [BurstCompile]
    internal unsafe struct ListWantedJob : IJob
    {
        [ReadOnly] public NativeArray<CloudPages> Clouds;
        [ReadOnly] public NativeArray<SelectedNode> Nodes;
        public uint Frame;
        public NativeList<SelectedNode> Wanted; // The parent of a listed node is its rank.

        public void Execute()
        {
            Wanted.Clear();
            for (int i = 0; i < Nodes.Length; i++)
            {
                var node = Nodes[i];
                var page = Clouds[node.Cloud].Pages + node.Page;
                if (page->States[node.Node].Slot != NodeState.NoSlot || page->IsHole(node.Node) ||
                    (int)(Frame - page->RetryFrame) < 0)
                    continue;
                node.Parent = i;
                Wanted.Add(node);
            }
        }
    }

    // Lists complete nodes whose ancestors are complete. A hole or a hidden node hides only itself. A node fades in: it begins
    // with none of its points, unless it has just come into view. What was drawn and is no longer selected fades out, as far as
    // the budget of points goes.
    [BurstCompile]
    internal unsafe struct ListDrawnJob : IJob
    {
        [ReadOnly] public NativeArray<CloudPages> Clouds;
        [ReadOnly] public NativeArray<SelectedNode> Selected;
        public NativeArray<CachedNode> Nodes;
        public uint Frame;
        public float FadeStep; // The change of a frame; 1 if nothing fades.
        public long PointBudget;
        public NativeList<DrawnNode> Drawn;
        public NativeList<DrawnNode> LastDrawn; // Scratch.
        public NativeList<int> DrawnOfSelected;
        public NativeReference<DrawnTotals> Totals;

        public void Execute()
        {
            LastDrawn.Clear();
            if (FadeStep < 1)
                LastDrawn.AddRange(Drawn.AsArray());
            Drawn.Clear();
            DrawnOfSelected.Clear();
            var totals = new DrawnTotals { IsAll = true };
            ListSelected(ref totals);
            ListFadingOut(ref totals);
            Totals.Value = totals;
        }

        void ListSelected(ref DrawnTotals totals)
        {
            for (int i = 0; i < Selected.Length; i++)
            {
                var node = Selected[i];
                var page = Clouds[node.Cloud].Pages + node.Page;
                int slot = page->States[node.Node].Slot;
                int parent = node.Parent < 0 ? StreamContext.NotDrawn : DrawnOfSelected[node.Parent];
                bool isHole = page->IsHole(node.Node);
                bool isComplete = slot != NodeState.NoSlot && Nodes[slot].Phase == CachePhase.Resident;
                totals.IsAll &= isHole || isComplete;
                bool isShown = parent != StreamContext.NotLoaded && (isHole || isComplete);
                if (!isShown || isHole || Nodes[slot].IsHidden)
                {
                    DrawnOfSelected.Add(isShown ? StreamContext.NotDrawn : StreamContext.NotLoaded);
                    continue;
                }
                DrawnOfSelected.Add(Drawn.Length);
                float fade = FadeStep >= 1 ? 1
                    : Nodes[slot].DrawnFrame == Frame - 1 ? math.min(1, Nodes[slot].Fade + FadeStep)
                    : page->States[node.Node].InViewSinceFrame != Frame || node.Parent < 0 ? 0
                    : parent >= 0 ? Nodes[Drawn[parent].Slot].Fade : 1;
                Add(new DrawnNode { Cloud = node.Cloud, Page = node.Page, Node = node.Node, Parent = parent, Slot = slot }, fade,
                    ref totals);
            }
        }

        void ListFadingOut(ref DrawnTotals totals)
        {
            for (int i = 0; i < LastDrawn.Length; i++)
            {
                var node = LastDrawn[i];
                var cached = Nodes[node.Slot];
                float fade = cached.Fade - FadeStep;
                if (cached.DrawnFrame != Frame - 1 || cached.Phase != CachePhase.Resident || cached.IsHidden || fade <= 0 ||
                    !Clouds[node.Cloud].IsFadingOut(LastDrawn.AsArray(), i, Frame))
                    continue;
                if (node.Parent >= 0)
                {
                    var parent = Nodes[LastDrawn[node.Parent].Slot];
                    if (parent.DrawnFrame != Frame)
                        continue;
                    node.Parent = parent.DrawnIndex;
                }
                if (totals.Points + (long)(ShareOf(fade, node.Parent) * Clouds[node.Cloud].PointsOf(node)) > PointBudget)
                    continue;
                Add(node, fade, ref totals);
            }
        }

        void Add(DrawnNode node, float fade, ref DrawnTotals totals)
        {
            var cached = (CachedNode*)Nodes.GetUnsafePtr() + node.Slot;
            cached->DrawnFrame = Frame;
            cached->DrawnIndex = Drawn.Length;
            cached->Fade = fade;
            node.Version = cached->Version;
            node.Range = cached->Range;
            node.Tint = cached->Tint;
            node.DrawnFraction = ShareOf(fade, node.Parent);
            Drawn.Add(node);
            totals.Points += (long)(node.DrawnFraction * Clouds[node.Cloud].PointsOf(node));
            totals.FadingNodes += fade < 1 ? 1 : 0;
        }

        // Where nothing is, few points cover much: slow at first. Detail comes fast at first, since what the camera nears changes
        // more pixels the later it comes; never more of it than of what it is the detail of.
        float ShareOf(float fade, int parent) => parent < 0 ? fade * fade : (2 - fade) * fade * Drawn[parent].DrawnFraction;
    }

    internal struct DrawnTotals
    {
        public long Points;
        public int FadingNodes;
        public bool IsAll;
    }

    internal unsafe struct CloudPages
    {
        [NativeDisableUnsafePtrRestriction] public HierarchyPage* Pages; // Null for a removed cloud.

        public readonly NodeState StateOf(SelectedNode node) => Pages[node.Page].States[node.Node];

        public readonly long PointsOf(in DrawnNode node) => Pages[node.Page].Nodes[node.Node].PointCount;

        // Whether a node that the last frame drew is not selected any more, but in view: the selection says so of children of
        // what it chose.
        public readonly bool IsFadingOut(NativeArray<DrawnNode> drawn, int index, uint frame)
        {
            if (Pages == null || StateOf(drawn[index]).SelectedFrame == frame)
                return false;
            int above = drawn[index].Parent;
            for (; above >= 0 && StateOf(drawn[above]).SelectedFrame != frame; above = drawn[index].Parent)
                index = above;
            return above < 0 || StateOf(drawn[index]).VisitedFrame == frame;
        }

        readonly NodeState StateOf(in DrawnNode node) => Pages[node.Page].States[node.Node];
    }

    /// <summary>A node to draw: it and all nodes above it are complete.</summary>
    public struct DrawnNode
    {
        public int Cloud;
        public int Page;
        public int Node;

        /// <summary>Index of the node above it among those drawn; -1 if that one is not drawn or does not exist.</summary>
        public int Parent;

        /// <summary>Its slot in the <see cref="NodeCache"/>.</summary>
        public int Slot;

        /// <summary>See <see cref="CachedNode.Version"/>.</summary>
        public int Version;

        /// <summary>See <see cref="CachedNode.Tint"/>.</summary>
        public uint Tint;

        /// <summary>The share of its points that is drawn: 1 unless the node appears or leaves.</summary>
        public float DrawnFraction;

        /// <summary>Its planes, one after the other in the order of <see cref="NodeSource.Planes"/>.</summary>
        public PoolRange Range;
    }
}
