using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>
    /// The records of a page as temporary files have them: of each word of a record only the bits that differ within the block.
    /// <code>
    /// number of records, bytes that follow (4 each)
    /// for each word: what all records have in common (4) | which bits of the difference to it any has (4) | which bits repeat
    ///     those 8 below them (4) | the bits of the second, of all records, padded to whole words
    /// </code>
    /// Where that is no less than the records, they follow as they are. Pages and records are aligned to words.
    /// </summary>
    internal static unsafe class RecordBlock
    {
        public const int HeaderBytes = 2 * sizeof(uint);

        const int WordsBeforeBits = 3;

        // A byte of 16 bits that repeats the other one, as in colours of 8 bits.
        const uint LowRepeated = 0xff00, HighRepeated = 0xff000000;

        /// <summary>Consecutive bits of a word.</summary>
        struct BitRuns
        {
            const int MaxCount = 16;

            public int Count;
            fixed int m_shift[MaxCount];
            fixed uint m_mask[MaxCount];

            public BitRuns(uint bits)
            {
                Count = 0;
                m_shift[0] = m_shift[1] = 0;
                m_mask[0] = m_mask[1] = 0;
                for (int done = 0; bits != 0; Count++)
                {
                    int first = math.tzcnt(bits);
                    uint rest = bits >> first;
                    int length = rest == uint.MaxValue ? 32 : math.tzcnt(~rest);
                    uint mask = (uint)((1UL << length) - 1) << first;
                    m_shift[Count] = first - done;
                    m_mask[Count] = mask;
                    done += length;
                    bits &= ~mask;
                }
            }

            public bool AreTwo => Count <= 2;

            public (int Shift, uint Mask) First => (m_shift[0], m_mask[0]);

            /// <summary>No bits if there is only one.</summary>
            public (int Shift, uint Mask) Second => (m_shift[1], m_mask[1]);

            public uint Gather(uint value)
            {
                uint gathered = 0;
                for (int i = 0; i < Count; i++)
                    gathered |= (value & m_mask[i]) >> m_shift[i];
                return gathered;
            }

            public uint Scatter(uint gathered)
            {
                uint value = 0;
                for (int i = 0; i < Count; i++)
                    value |= gathered << m_shift[i] & m_mask[i];
                return value;
            }
        }

        public static byte* Of(RecordPages.Page* page) => RecordPages.RecordsOf(page) - HeaderBytes;

        public static long MaxBytes(int strideBytes) => HeaderBytes + (long)RecordPages.RecordsPerPage * strideBytes;

        /// <summary>Packs the records of a page in their place.</summary>
        /// <param name="scratch">Has room for the records.</param>
        public static void Pack(RecordPages.Page* page, int strideBytes, uint* scratch)
        {
            var records = RecordPages.RecordsOf(page);
            int bytes = sizeof(uint) * PackWords((uint*)records, page->Count, strideBytes / sizeof(uint), scratch);
            if (bytes > 0)
                UnsafeUtility.MemCpy(records, scratch, bytes);
            else
                bytes = page->Count * strideBytes;
            var header = (uint*)Of(page);
            header[0] = (uint)page->Count;
            header[1] = (uint)bytes;
            page->BlockBytes = HeaderBytes + bytes;
        }

        // Returns the words written; 0 if they would not be fewer.
        static int PackWords(uint* records, int count, int words, uint* to)
        {
            int written = 0;
            for (int w = 0; w < words; w++)
            {
                var (common, bits, repeated) = FindBits(records + w, count, words);
                int size = WordsBeforeBits + WordsOf(count, math.countbits(bits));
                if (written + size >= count * words)
                    return 0;
                to[written] = common;
                to[written + 1] = bits;
                to[written + 2] = repeated;
                if (bits != 0)
                    WriteBits(records + w, count, words, common, bits, to + written + WordsBeforeBits);
                written += size;
            }
            return written;
        }

        static (uint Common, uint Bits, uint Repeated) FindBits(uint* first, int count, int words)
        {
            uint differ = 0;
            uint* at = first;
            for (int i = 0; i < count; i++, at += words)
                differ |= *at ^ *first;
            // Most words are the same in all records.
            if (differ == 0)
                return (*first, 0, 0);
            uint min = uint.MaxValue, max = 0, differBy8 = 0;
            at = first;
            for (int i = 0; i < count; i++, at += words)
            {
                min = math.min(min, *at);
                max = math.max(max, *at);
                differBy8 |= *at ^ *at << 8;
            }
            uint repeated = ((differBy8 & LowRepeated) == 0 ? LowRepeated : 0)
                | ((differBy8 & HighRepeated) == 0 ? HighRepeated : 0);
            // Coordinates are next to one another; other words have several values, some of them equal.
            uint range = uint.MaxValue >> math.lzcnt(max - min);
            return math.countbits(range) <= math.countbits(differ & ~repeated) ? (min, range, 0)
                : (*first & ~differ, differ & ~repeated, repeated);
        }

        static int WordsOf(int count, int bits) => (count * bits + 31) / 32;

        static void WriteBits(uint* from, int count, int words, uint common, uint mask, uint* to)
        {
            var runs = new BitRuns(mask);
            var (shift1, mask1) = runs.First;
            var (shift2, mask2) = runs.Second;
            bool areTwo = runs.AreTwo;
            int bits = math.countbits(mask), filled = 0;
            ulong waiting = 0;
            for (int i = 0; i < count; i++, from += words)
            {
                uint value = *from - common;
                value = areTwo ? (value & mask1) >> shift1 | (value & mask2) >> shift2 : runs.Gather(value);
                waiting |= (ulong)value << filled;
                filled += bits;
                if (filled < 32)
                    continue;
                *to++ = (uint)waiting;
                waiting >>= 32;
                filled -= 32;
            }
            if (filled > 0)
                *to = (uint)waiting;
        }

        /// <returns>False if the block is damaged: the records are then zeros, or wrong.</returns>
        public static bool Unpack(in UnpackRequest part, int strideBytes)
        {
            var header = (uint*)part.Block;
            int words = strideBytes / sizeof(uint), all = part.BlockRecords * words;
            int left = (part.BlockBytes - HeaderBytes) / sizeof(uint);
            if (header[0] != part.BlockRecords || header[1] + HeaderBytes != part.BlockBytes || left > all)
            {
                UnsafeUtility.MemClear(part.Records, (long)part.Count * strideBytes);
                return false;
            }
            uint* from = header + 2;
            if (left == all)
            {
                UnsafeUtility.MemCpy(part.Records, (byte*)from + (long)part.First * strideBytes, (long)part.Count * strideBytes);
                return true;
            }
            for (int w = 0; w < words; w++)
            {
                int size = WordsBeforeBits
                    + (left < WordsBeforeBits ? 0 : WordsOf(part.BlockRecords, math.countbits(from[1])));
                left -= size;
                if (left < 0)
                {
                    UnsafeUtility.MemClear(part.Records, (long)part.Count * strideBytes);
                    return false;
                }
                ReadBits(from, part.First, part.Count, (uint*)part.Records + w, words);
                from += size;
            }
            return left == 0;
        }

        static void ReadBits(uint* from, int first, int wanted, uint* to, int words)
        {
            uint common = from[0], mask = from[1], repeated = from[2];
            if (mask == 0)
            {
                for (int i = 0; i < wanted; i++, to += words)
                    *to = common;
                return;
            }
            var runs = new BitRuns(mask);
            var (shift1, mask1) = runs.First;
            var (shift2, mask2) = runs.Second;
            bool areTwo = runs.AreTwo;
            from += WordsBeforeBits;
            int bits = math.countbits(mask), at = first * bits;
            for (int i = 0; i < wanted; i++, to += words, at += bits)
            {
                uint* word = from + (at >> 5);
                uint value = (uint)((word[0] | (ulong)word[1] << 32) >> (at & 31));
                // What is above its bits is in no mask.
                value = areTwo ? value << shift1 & mask1 | value << shift2 & mask2 : runs.Scatter(value);
                *to = common + value + (value << 8 & repeated);
            }
        }
    }

    /// <summary>Some records of a block in memory, and where they go. Blittable.</summary>
    internal unsafe struct UnpackRequest
    {
        [NativeDisableUnsafePtrRestriction] public byte* Block;
        public int BlockBytes;
        public int BlockRecords;
        public int First;
        public int Count;
        [NativeDisableUnsafePtrRestriction] public byte* Records;
    }

    /// <summary>Packs consecutive pages of a list, each in its place.</summary>
    [BurstCompile]
    internal unsafe struct PackRecordsJob : IJob
    {
        public const int PagesPerRun = 32; // A few: this many take about a millisecond.

        public RecordPages Pages;
        public int StrideBytes;
        public SliceTimes SliceTimes;

        public static JobHandle Schedule(PackRecordsJob job, JobHandle before)
        {
            for (var rest = job.Pages; rest.PageCount > 0; rest.PageCount -= PagesPerRun)
            {
                // The list stays one.
                job.Pages = rest;
                job.Pages.PageCount = math.min(PagesPerRun, rest.PageCount);
                before = job.Schedule(before);
                for (int i = 0; i < job.Pages.PageCount; i++)
                    rest.First = rest.First->Next;
            }
            return before;
        }

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            var scratch = new NativeArray<uint>(RecordPages.RecordsPerPage * StrideBytes / sizeof(uint), Allocator.Temp,
                NativeArrayOptions.UninitializedMemory);
            var page = Pages.First;
            for (int p = 0; p < Pages.PageCount; p++, page = page->Next)
                RecordBlock.Pack(page, StrideBytes, (uint*)scratch.GetUnsafePtr());
            SliceTimes.End(begin);
        }
    }
}
