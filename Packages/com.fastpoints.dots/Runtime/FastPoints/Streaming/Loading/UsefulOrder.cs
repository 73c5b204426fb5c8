using System;
using Unity.Collections;

namespace FastPoints.Streaming
{
    /// <summary>The slots of a cache and their order, from the least to the most useful. Blittable, for jobs.</summary>
    internal struct UsefulOrder : IDisposable
    {
        public NativeList<CachedNode> Slots;

        /// <summary>The least and the most useful slot, or <see cref="NodeCache.None"/>.</summary>
        NativeReference<Ends> m_ends;

        struct Ends
        {
            public int Least;
            public int Most;
        }

        public UsefulOrder(Allocator allocator)
        {
            Slots = new NativeList<CachedNode>(1024, allocator);
            m_ends = new NativeReference<Ends>(new Ends { Least = NodeCache.None, Most = NodeCache.None }, allocator);
        }

        public int LeastUseful => m_ends.Value.Least;

        /// <summary>Makes it the most useful.</summary>
        public void Use(int slot, uint frame, int rank)
        {
            ref var used = ref Slots.ElementAt(slot);
            used.UsedFrame = frame;
            used.Rank = rank;
            if (m_ends.Value.Most == slot)
                return;
            Unlink(slot);
            Append(slot);
        }

        public void Append(int slot)
        {
            var ends = m_ends.Value;
            ref var added = ref Slots.ElementAt(slot);
            added.LessUseful = ends.Most;
            added.MoreUseful = NodeCache.None;
            if (ends.Most != NodeCache.None)
                Slots.ElementAt(ends.Most).MoreUseful = slot;
            else
                ends.Least = slot;
            ends.Most = slot;
            m_ends.Value = ends;
        }

        public void Unlink(int slot)
        {
            var ends = m_ends.Value;
            var gone = Slots[slot];
            if (gone.LessUseful != NodeCache.None)
                Slots.ElementAt(gone.LessUseful).MoreUseful = gone.MoreUseful;
            else
                ends.Least = gone.MoreUseful;
            if (gone.MoreUseful != NodeCache.None)
                Slots.ElementAt(gone.MoreUseful).LessUseful = gone.LessUseful;
            else
                ends.Most = gone.LessUseful;
            m_ends.Value = ends;
        }

        public void Dispose()
        {
            Slots.Dispose();
            m_ends.Dispose();
        }
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
}
