using System;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    // Gives out ranges of consecutive slots and takes them back: it keeps books on abstract indices, whatever memory they stand
    // for. Free ranges lie in lists by the power of two of their length; a range that is given back merges with its free
    // neighbours. Both take constant time, but where only the list of its own length may have room. The first and the last slot
    // of a range hold its length: positive if it is taken, negative if it is free.
    internal struct RangeAllocator : IDisposable
    {
        const int None = -1;
        const int BinCount = 31;
        const int MaxTries = 8; // How many ranges of the wanted length's own list are tried: all in longer lists are long enough.

        NativeArray<int> m_length;
        NativeArray<int> m_next;
        NativeArray<int> m_previous;
        NativeArray<int> m_firstOfBin;
        uint m_occupiedBins;
        int m_tooLong; // No free range is as long as this; nothing was given back since it was found out.

        public RangeAllocator(int capacity, Allocator allocator)
        {
            if (capacity < 1)
                throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "wanted at least 1");
            m_length = new NativeArray<int>(capacity, allocator);
            m_next = new NativeArray<int>(capacity, allocator, NativeArrayOptions.UninitializedMemory);
            m_previous = new NativeArray<int>(capacity, allocator, NativeArrayOptions.UninitializedMemory);
            m_firstOfBin = new NativeArray<int>(BinCount, allocator);
            for (int bin = 0; bin < BinCount; bin++)
                m_firstOfBin[bin] = None;
            m_occupiedBins = 0;
            m_tooLong = int.MaxValue;
            UsedLength = 0;
            AddFree(0, capacity);
        }

        public bool IsCreated => m_length.IsCreated;
        public int UsedLength { get; private set; }

        // The first slot, or -1 if no free range is long enough.
        public int Allocate(int count)
        {
            int range = count < m_tooLong ? Find(count) : None;
            if (range < 0)
            {
                // A full pool is asked again and again while nodes are evicted.
                if (count > 0)
                    m_tooLong = math.min(m_tooLong, count);
                return None;
            }
            int length = -m_length[range];
            RemoveFree(range, length);
            if (length > count)
                AddFree(range + count, length - count);
            Mark(range, count, count);
            UsedLength += count;
            return range;
        }

        public void Free(int first)
        {
            int length = first >= 0 && first < m_length.Length ? m_length[first] : 0;
            if (length <= 0 || first + length > m_length.Length || m_length[first + length - 1] != length)
                throw new ArgumentException("slot " + first + " is not the first of a range that was taken", nameof(first));
            UsedLength -= length;
            // What lies inside a longer range must not pass for a range.
            Mark(first, length, 0);
            int begin = first, end = first + length;
            if (begin > 0 && m_length[begin - 1] < 0)
            {
                int before = -m_length[begin - 1];
                RemoveFree(begin - before, before);
                begin -= before;
            }
            if (end < m_length.Length && m_length[end] < 0)
            {
                int after = -m_length[end];
                RemoveFree(end, after);
                end += after;
            }
            AddFree(begin, end - begin);
        }

        // Keeps the first slots of a range, at least one, and frees the rest.
        public void Shorten(int first, int count)
        {
            int length = first >= 0 && first < m_length.Length ? m_length[first] : 0;
            if (count < 1 || count > length)
                throw new ArgumentOutOfRangeException(nameof(count), count, "wanted 1 to " + length);
            if (count == length)
                return;
            Mark(first, length, 0);
            Mark(first, count, count);
            Mark(first + count, length - count, length - count);
            Free(first + count);
        }

        public void Dispose()
        {
            if (!m_length.IsCreated)
                return;
            m_length.Dispose();
            m_next.Dispose();
            m_previous.Dispose();
            m_firstOfBin.Dispose();
        }

        // An inconsistency in the bookkeeping, or null. It examines every slot.
        public string FindProblem()
        {
            int used = 0, free = 0;
            bool wasFree = false;
            for (int at = 0; at < m_length.Length;)
            {
                int length = math.abs(m_length[at]);
                if (length == 0 || at + length > m_length.Length || m_length[at + length - 1] != m_length[at])
                    return "slot " + at + " begins a range of " + m_length[at] + " that does not end so";
                bool isFree = m_length[at] < 0;
                if (isFree && wasFree)
                    return "slot " + at + " begins a free range beside another";
                used += isFree ? 0 : length;
                free += isFree ? 1 : 0;
                wasFree = isFree;
                at += length;
            }
            if (used != UsedLength)
                return "counted " + used + " slots in use, wanted " + UsedLength;
            int listed = 0;
            for (int bin = 0; bin < BinCount; bin++)
            {
                if (m_firstOfBin[bin] >= 0 != ((m_occupiedBins >> bin & 1) != 0))
                    return "bin " + bin + " is not as marked";
                for (int range = m_firstOfBin[bin], before = None; range >= 0; before = range, range = m_next[range], listed++)
                    if (m_length[range] >= 0 || BinOf(-m_length[range]) != bin || m_previous[range] != before || listed > free)
                        return "range " + range + " of " + m_length[range] + " is in bin " + bin;
            }
            return listed == free ? null : "listed " + listed + " free ranges, wanted " + free;
        }

        static int BinOf(int length) => 31 - math.lzcnt(length);

        int Find(int count)
        {
            if (count < 1 || count > m_length.Length)
                return None;
            int bin = BinOf(count), tries = 0;
            for (int range = m_firstOfBin[bin]; range >= 0 && tries < MaxTries; range = m_next[range], tries++)
                if (-m_length[range] >= count)
                    return range;
            uint longer = m_occupiedBins >> bin >> 1;
            if (longer != 0)
                return m_firstOfBin[bin + 1 + math.tzcnt(longer)];
            // Searching all of its own list is better than reporting that there is no room.
            for (int range = m_firstOfBin[bin]; range >= 0; range = m_next[range])
                if (-m_length[range] >= count)
                    return range;
            return None;
        }

        void Mark(int first, int count, int length)
        {
            m_length[first] = length;
            m_length[first + count - 1] = length;
        }

        void AddFree(int first, int length)
        {
            m_tooLong = length >= m_tooLong ? int.MaxValue : m_tooLong;
            int bin = BinOf(length);
            Mark(first, length, -length);
            m_next[first] = m_firstOfBin[bin];
            m_previous[first] = None;
            if (m_firstOfBin[bin] >= 0)
                m_previous[m_firstOfBin[bin]] = first;
            m_firstOfBin[bin] = first;
            m_occupiedBins |= 1u << bin;
        }

        void RemoveFree(int first, int length)
        {
            int bin = BinOf(length);
            if (m_next[first] >= 0)
                m_previous[m_next[first]] = m_previous[first];
            if (m_previous[first] >= 0)
                m_next[m_previous[first]] = m_next[first];
            else
                m_firstOfBin[bin] = m_next[first];
            if (m_firstOfBin[bin] < 0)
                m_occupiedBins &= ~(1u << bin);
            Mark(first, length, 0);
        }
    }
}
