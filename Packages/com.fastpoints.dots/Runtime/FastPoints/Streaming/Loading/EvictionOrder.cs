using System;
using Unity.Collections;

namespace FastPoints.Streaming
{
    // The slots of a cache in eviction order: the first goes first.
    internal struct EvictionOrder : IDisposable
    {
        public NativeList<CachedNode> Nodes;
        NativeReference<Ends> m_ends; // The slots that go first and last, or NodeCache.None.

        struct Ends
        {
            public int First;
            public int Last;
        }

        public EvictionOrder(Allocator allocator)
        {
            Nodes = new NativeList<CachedNode>(1024, allocator);
            m_ends = new NativeReference<Ends>(new Ends { First = NodeCache.None, Last = NodeCache.None }, allocator);
        }

        public int NextToEvict => m_ends.Value.First;

        public void Touch(int slot, uint frame, int rank)
        {
            ref var used = ref Nodes.ElementAt(slot);
            used.UsedFrame = frame;
            used.Rank = rank;
            if (m_ends.Value.Last == slot)
                return;
            Unlink(slot);
            Append(slot);
        }

        public void Append(int slot)
        {
            var ends = m_ends.Value;
            ref var added = ref Nodes.ElementAt(slot);
            added.Previous = ends.Last;
            added.Next = NodeCache.None;
            if (ends.Last != NodeCache.None)
                Nodes.ElementAt(ends.Last).Next = slot;
            else
                ends.First = slot;
            ends.Last = slot;
            m_ends.Value = ends;
        }

        public void Unlink(int slot)
        {
            var ends = m_ends.Value;
            var removed = Nodes[slot];
            if (removed.Previous != NodeCache.None)
                Nodes.ElementAt(removed.Previous).Next = removed.Next;
            else
                ends.First = removed.Next;
            if (removed.Next != NodeCache.None)
                Nodes.ElementAt(removed.Next).Previous = removed.Previous;
            else
                ends.Last = removed.Previous;
            m_ends.Value = ends;
        }

        public void Dispose()
        {
            Nodes.Dispose();
            m_ends.Dispose();
        }
    }

    internal struct CachedNode
    {
        public const uint White = 0xFFFFFFFF;

        public int Cloud;
        public int Page;
        public int Node;
        public PoolRange Range;
        public CachePhase Phase;
        public int Version; // Must be remembered along with a slot's number: it rises when the slot is released.

        // Frame of the last selection or prefetch that wanted it, and its rank there: 0 is the most needed.
        public uint UsedFrame;
        public int Rank;

        // The last frame that listed it to be drawn, its index there, and how far it has appeared then: 0 to 1, in time.
        public uint DrawnFrame;
        public int DrawnIndex;
        public float Fade;
        public bool IsHidden; // Not drawn even if it is loaded.
        public bool IsPinned; // Kept as long as there is any memory for it.
        public uint Tint; // Multiplies its points' colours: sRGB, with red, green, blue, alpha from the lowest byte.

        // Its neighbours in the eviction order, or NodeCache.None.
        public int Previous;
        public int Next;
    }

    internal enum CachePhase : byte
    {
        Free,
        Requested, // Its bytes are in flight, or wait to be copied.
        // A job writes to its memory.
        Uploading,
        Resident,
    }
}
