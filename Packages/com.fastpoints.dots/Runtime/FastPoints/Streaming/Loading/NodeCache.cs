using System;
using Unity.Collections;

namespace FastPoints.Streaming
{
    /// <summary>The nodes that have memory, from the least to the most useful: first those that no selection has wanted for
    /// longest, then those that the last one wanted, in reverse order. Main thread.</summary>
    internal sealed class NodeCache : IDisposable
    {
        public const int None = -1;

        NativeList<CachedNode> m_slots;
        NativeList<int> m_free;
        NativeList<int> m_pinned;
        int m_mostUseful = None;

        public NodeCache()
        {
            m_slots = new NativeList<CachedNode>(1024, Allocator.Persistent);
            m_free = new NativeList<int>(1024, Allocator.Persistent);
            m_pinned = new NativeList<int>(Allocator.Persistent);
        }

        public int Count { get; private set; }

        /// <summary>The first node to evict, or <see cref="None"/>.</summary>
        public int LeastUseful { get; private set; } = None;

        public CachedNode this[int slot] => m_slots[slot];

        /// <summary>All slots, including free ones.</summary>
        public NativeArray<CachedNode> Slots => m_slots.AsArray();

        /// <summary>Number of slots that were ever in use, including free ones.</summary>
        public int SlotCount => m_slots.Length;

        public bool IsAlive(int slot, int version) => m_slots[slot].Version == version;

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
                slot = m_slots.Length;
                m_slots.Add(default);
            }
            m_slots[slot] = new CachedNode
            {
                Cloud = cloud,
                Page = page,
                Node = node,
                Run = run,
                Phase = CachePhase.Requested,
                Version = m_slots[slot].Version,
                Tint = CachedNode.White,
            };
            Append(slot);
            Count++;
            return slot;
        }

        public void Remove(int slot)
        {
            Unlink(slot);
            SetPinned(slot, false);
            int version = m_slots[slot].Version;
            m_slots[slot] = new CachedNode { Version = version + 1 };
            m_free.Add(slot);
            Count--;
        }

        public void SetHidden(int slot, bool value) => m_slots.ElementAt(slot).IsHidden = value;

        public void SetTint(int slot, uint rgba) => m_slots.ElementAt(slot).Tint = rgba;

        public void SetPinned(int slot, bool value)
        {
            ref var pinned = ref m_slots.ElementAt(slot);
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

        /// <summary>Makes pinned nodes more useful than all others.</summary>
        public void UsePinned(uint frame)
        {
            for (int i = 0; i < m_pinned.Length; i++)
                Use(m_pinned[i], frame, -1);
        }

        public void SetPhase(int slot, CachePhase phase) => m_slots.ElementAt(slot).Phase = phase;

        public void SetRun(int slot, PoolRange run) => m_slots.ElementAt(slot).Run = run;

        /// <summary>Makes it the most useful.</summary>
        public void Use(int slot, uint frame, int rank)
        {
            ref var used = ref m_slots.ElementAt(slot);
            used.UsedFrame = frame;
            used.Rank = rank;
            if (m_mostUseful == slot)
                return;
            Unlink(slot);
            Append(slot);
        }

        public void Dispose()
        {
            if (!m_slots.IsCreated)
                return;
            m_slots.Dispose();
            m_free.Dispose();
            m_pinned.Dispose();
        }

        void Append(int slot)
        {
            ref var added = ref m_slots.ElementAt(slot);
            added.LessUseful = m_mostUseful;
            added.MoreUseful = None;
            if (m_mostUseful != None)
                m_slots.ElementAt(m_mostUseful).MoreUseful = slot;
            else
                LeastUseful = slot;
            m_mostUseful = slot;
        }

        void Unlink(int slot)
        {
            var gone = m_slots[slot];
            if (gone.LessUseful != None)
                m_slots.ElementAt(gone.LessUseful).MoreUseful = gone.MoreUseful;
            else
                LeastUseful = gone.MoreUseful;
            if (gone.MoreUseful != None)
                m_slots.ElementAt(gone.MoreUseful).LessUseful = gone.LessUseful;
            else
                m_mostUseful = gone.LessUseful;
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
