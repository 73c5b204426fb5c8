using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    // They run on the main thread, between steps that need their results at once: a job that is scheduled and awaited costs more
    // than all of one of them.

    // Orders the cache by what a frame has chosen: prefetched nodes go before selected ones, and those before pinned ones.
    [BurstCompile]
    internal struct TouchNodesJob : IJob
    {
        [ReadOnly] public NativeArray<CloudPages> Clouds;
        [ReadOnly] public NativeArray<SelectedNode> Selected;
        [ReadOnly] public NativeArray<SelectedNode> Prefetched;
        [ReadOnly] public NativeArray<int> Pinned;
        public uint Frame;
        public EvictionOrder Order;

        public void Execute()
        {
            Touch(Prefetched, NodeReadQueue.FirstPrefetchRank);
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

    // Lists complete nodes whose ancestors are complete. A hole or a hidden node hides only itself.
    [BurstCompile]
    internal unsafe struct ListDrawnJob : IJob
    {
        [ReadOnly] public NativeArray<CloudPages> Clouds;
        [ReadOnly] public NativeArray<SelectedNode> Selected;
        [ReadOnly] public NativeArray<CachedNode> Slots;
        public NativeList<DrawnNode> Drawn;
        public NativeList<int> DrawnOfSelected;
        public NativeReference<DrawnTotals> Totals;

        public void Execute()
        {
            Drawn.Clear();
            DrawnOfSelected.Clear();
            var totals = new DrawnTotals { IsAll = true };
            for (int i = 0; i < Selected.Length; i++)
            {
                var node = Selected[i];
                var page = Clouds[node.Cloud].Pages + node.Page;
                int slot = page->States[node.Node].Slot;
                int parent = node.Parent < 0 ? StreamContext.NotDrawn : DrawnOfSelected[node.Parent];
                bool isHole = page->IsHole(node.Node);
                bool isComplete = slot != NodeState.NoSlot && Slots[slot].Phase == CachePhase.Resident;
                totals.IsAll &= isHole || isComplete;
                bool isShown = parent != StreamContext.NotShown && (isHole || isComplete);
                if (!isShown || isHole || Slots[slot].IsHidden)
                {
                    DrawnOfSelected.Add(isShown ? StreamContext.NotDrawn : StreamContext.NotShown);
                    continue;
                }
                DrawnOfSelected.Add(Drawn.Length);
                Drawn.Add(new DrawnNode
                {
                    Cloud = node.Cloud,
                    Page = node.Page,
                    Node = node.Node,
                    Parent = parent,
                    Slot = slot,
                    Version = Slots[slot].Version,
                    Range = Slots[slot].Range,
                    Tint = Slots[slot].Tint,
                });
                totals.Points += page->Nodes[node.Node].PointCount;
            }
            Totals.Value = totals;
        }
    }

    internal struct DrawnTotals
    {
        public long Points;
        public bool IsAll;
    }

    internal unsafe struct CloudPages
    {
        /// <summary>Null for a removed cloud.</summary>
        [NativeDisableUnsafePtrRestriction] public HierarchyPage* Pages;

        public readonly NodeState StateOf(SelectedNode node) => Pages[node.Page].States[node.Node];
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

        /// <summary>Its planes, one after the other in the order of <see cref="NodeSource.Planes"/>.</summary>
        public PoolRange Range;
    }
}
