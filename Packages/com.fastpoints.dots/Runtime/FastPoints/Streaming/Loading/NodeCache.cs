using System;
using Unity.Collections;

namespace FastPoints.Streaming
{
    // The nodes that have memory, in eviction order: nodes unused for longest first, then prefetched, fading-out, selected
    // (least needed first), and pinned ones last. Main thread.
    internal sealed class NodeCache : IDisposable
    {
        public const int None = -1;

        EvictionOrder m_order = new EvictionOrder(Allocator.Persistent);
        NativeList<int> m_free = new NativeList<int>(1024, Allocator.Persistent);
        NativeList<int> m_pinned = new NativeList<int>(Allocator.Persistent);

        public int Count { get; private set; }

        public int NextToEvict => m_order.NextToEvict;

        public EvictionOrder Order => m_order;
        public NativeArray<int> Pinned => m_pinned.AsArray(); // Evicted last.

        public CachedNode this[int slot] => m_order.Nodes[slot];

        public NativeArray<CachedNode> Nodes => m_order.Nodes.AsArray();
        public int SlotCount => m_order.Nodes.Length; // Slots that were ever in use, including free ones.

        public bool IsValid(int slot, int version) => m_order.Nodes[slot].Version == version;

        public int Add(int cloud, int page, int node, PoolRange range)
        {
            int slot;
            if (m_free.Length > 0)
            {
                slot = m_free[m_free.Length - 1];
                m_free.RemoveAt(m_free.Length - 1);
            }
            else
            {
                slot = m_order.Nodes.Length;
                m_order.Nodes.Add(default);
            }
            m_order.Nodes[slot] = new CachedNode
            {
                Cloud = cloud,
                Page = page,
                Node = node,
                Range = range,
                Phase = CachePhase.Requested,
                Version = m_order.Nodes[slot].Version,
                Tint = CachedNode.White,
            };
            m_order.Append(slot);
            Count++;
            return slot;
        }

        public void Remove(int slot)
        {
            m_order.Unlink(slot);
            SetPinned(slot, false);
            int version = m_order.Nodes[slot].Version;
            m_order.Nodes[slot] = new CachedNode { Version = version + 1 };
            m_free.Add(slot);
            Count--;
        }

        public void SetHidden(int slot, bool value) => m_order.Nodes.ElementAt(slot).IsHidden = value;

        public void SetTint(int slot, uint rgba) => m_order.Nodes.ElementAt(slot).Tint = rgba;

        public void SetPinned(int slot, bool value)
        {
            ref var pinned = ref m_order.Nodes.ElementAt(slot);
            if (pinned.IsPinned == value)
                return;
            pinned.IsPinned = value;
            if (value)
            {
                m_pinned.Add(slot);
                return;
            }
            for (int i = m_pinned.Length - 1; i >= 0; i--)
                if (m_pinned[i] == slot)
                    m_pinned.RemoveAtSwapBack(i);
        }

        public void SetPhase(int slot, CachePhase phase) => m_order.Nodes.ElementAt(slot).Phase = phase;

        public void SetRange(int slot, PoolRange range) => m_order.Nodes.ElementAt(slot).Range = range;

        public void Touch(int slot, uint frame, int rank) => m_order.Touch(slot, frame, rank);

        public void Dispose()
        {
            if (!m_free.IsCreated)
                return;
            m_order.Dispose();
            m_free.Dispose();
            m_pinned.Dispose();
        }
    }
}
