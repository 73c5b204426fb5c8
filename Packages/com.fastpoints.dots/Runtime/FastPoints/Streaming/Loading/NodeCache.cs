using System;
using Unity.Collections;

namespace FastPoints.Streaming
{
    /// <summary>The nodes that have memory, from the least to the most useful: first those that no selection has wanted for
    /// longest, then those that the last one wanted, in reverse order. Main thread.</summary>
    internal sealed class NodeCache : IDisposable
    {
        public const int None = -1;

        UsefulOrder m_order;
        NativeList<int> m_free;
        NativeList<int> m_pinned;

        public NodeCache()
        {
            m_order = new UsefulOrder(Allocator.Persistent);
            m_free = new NativeList<int>(1024, Allocator.Persistent);
            m_pinned = new NativeList<int>(Allocator.Persistent);
        }

        public int Count { get; private set; }

        /// <summary>The first node to evict, or <see cref="None"/>.</summary>
        public int LeastUseful => m_order.LeastUseful;

        /// <summary>For jobs of the main thread.</summary>
        public UsefulOrder Order => m_order;

        /// <summary>The slots that are kept as long as there is any memory for them.</summary>
        public NativeArray<int> Pinned => m_pinned.AsArray();

        public CachedNode this[int slot] => m_order.Slots[slot];

        /// <summary>All slots, including free ones.</summary>
        public NativeArray<CachedNode> Slots => m_order.Slots.AsArray();

        /// <summary>Number of slots that were ever in use, including free ones.</summary>
        public int SlotCount => m_order.Slots.Length;

        public bool IsAlive(int slot, int version) => m_order.Slots[slot].Version == version;

        /// <summary>Adds a slot as the most useful of all.</summary>
        public int Add(int cloud, int page, int node, PoolRange run)
        {
            int slot;
            if (m_free.Length > 0)
            {
                slot = m_free[m_free.Length - 1];
                m_free.RemoveAt(m_free.Length - 1);
            }
            else
            {
                slot = m_order.Slots.Length;
                m_order.Slots.Add(default);
            }
            m_order.Slots[slot] = new CachedNode
            {
                Cloud = cloud,
                Page = page,
                Node = node,
                Run = run,
                Phase = CachePhase.Requested,
                Version = m_order.Slots[slot].Version,
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
            int version = m_order.Slots[slot].Version;
            m_order.Slots[slot] = new CachedNode { Version = version + 1 };
            m_free.Add(slot);
            Count--;
        }

        public void SetHidden(int slot, bool value) => m_order.Slots.ElementAt(slot).IsHidden = value;

        public void SetTint(int slot, uint rgba) => m_order.Slots.ElementAt(slot).Tint = rgba;

        public void SetPinned(int slot, bool value)
        {
            ref var pinned = ref m_order.Slots.ElementAt(slot);
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

        public void SetPhase(int slot, CachePhase phase) => m_order.Slots.ElementAt(slot).Phase = phase;

        public void SetRun(int slot, PoolRange run) => m_order.Slots.ElementAt(slot).Run = run;

        /// <summary>Makes it the most useful.</summary>
        public void Use(int slot, uint frame, int rank) => m_order.Use(slot, frame, rank);

        public void Dispose()
        {
            if (!m_free.IsCreated)
                return;
            m_order.Dispose();
            m_free.Dispose();
            m_pinned.Dispose();
        }
    }

    /// <summary>The state of a node in the cache.</summary>
    internal enum CachePhase : byte
    {
        Free,
        /// <summary>Its bytes are in flight, or wait to be copied.</summary>
        Requested,
        /// <summary>A job writes to its memory.</summary>
        Uploading,
        /// <summary>It is complete and can be drawn.</summary>
        Resident,
    }

    /// <summary>A node that has memory in the pool.</summary>
    internal struct CachedNode
    {
        public const uint White = 0xFFFFFFFF;

        public int Cloud;
        public int Page;
        public int Node;
        public PoolRange Run;
        public CachePhase Phase;

        /// <summary>Must be remembered along with a slot's number: it rises when the slot is released.</summary>
        public int Version;

        /// <summary>Frame of the last selection or forecast that wanted it, and its rank there: 0 is the most needed.</summary>
        public uint UsedFrame;
        public int Rank;

        /// <summary>Whether it is not drawn even if it is loaded.</summary>
        public bool IsHidden;

        /// <summary>Whether it is kept as long as there is any memory for it.</summary>
        public bool IsPinned;

        /// <summary>Multiplies its points' colours: sRGB, with red, green, blue, alpha from the lowest byte; white leaves them
        /// unchanged.</summary>
        public uint Tint;

        /// <summary>Neighbours in the order of usefulness.</summary>
        public int LessUseful;
        public int MoreUseful;
    }
}
