using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octree
{
    /// <summary>
    /// Orders a chunk's records along the Morton curve, those at one place by their content, so that the order is the same
    /// however they came.
    /// </summary>
    /// <remarks>
    /// The first digit takes the top three octree levels; its buckets fit a core's cache and are sorted least significant digit
    /// first, as one number each:
    /// <code>
    /// bit 63 ........ n      n - 1 ........ 0
    ///     Morton bits left   record number
    /// </code>
    /// Where a chunk has more Morton bits than that leaves room for (a few points in a vast cube), and at equal places, the
    /// runs that are equal so far are sorted by comparing records.
    /// </remarks>
    [BurstCompile]
    public unsafe struct OrderChunkJob : IJob
    {
        const int FirstDigitBits = 9;
        const int FewRecords = 4096;

        public RecordPages Pages;
        public RecordLayout Layout;
        public GridCube Cube;

        /// <summary>Room for the records each: scratch.</summary>
        public NativeArray<ulong> Keys;
        public NativeArray<ulong> Scratch;

        /// <summary>Out: numbers of the records, in order.</summary>
        public NativeArray<uint> Order;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        void Run()
        {
            int count = (int)Pages.Count;
            int levels = math.min(Cube.SideLog2, Morton.BitsPerAxis);
            int keyBits = 3 * levels;
            int numberBits = 64 - math.lzcnt((ulong)Pages.PageCount * RecordPages.RecordsPerPage - 1);
            int firstBits = count < FewRecords ? 0 : math.min(keyBits, FirstDigitBits);
            int keptBits = math.min(keyBits - firstBits, 64 - numberBits);

            var pageTable = (RecordPages.Page**)UnsafeUtility.Malloc((long)Pages.PageCount * sizeof(void*), 16, Allocator.Temp);
            int pageCount = 0;
            for (var page = Pages.First; page != null; page = page->Next)
                pageTable[pageCount++] = page;
            var table = new RecordTable { Pages = pageTable, Layout = Layout, Corner = Cube.Corner };

            var keys = (ulong*)Keys.GetUnsafePtr();
            var scratch = (ulong*)Scratch.GetUnsafePtr();
            var order = (uint*)Order.GetUnsafePtr();
            int* start = stackalloc int[(1 << FirstDigitBits) + 1];
            MakeKeys(table, pageCount, levels, keys);
            Distribute(table, pageCount, keys, scratch, count, keyBits - firstBits, keptBits, numberBits, start);
            for (int bucket = 0; bucket < 1 << firstBits; bucket++)
            {
                int first = start[bucket], size = start[bucket + 1] - first;
                if (size > 0)
                    SortBucket(table, scratch + first, keys + first, order + first, size, numberBits, keptBits);
            }
            UnsafeUtility.Free(pageTable, Allocator.Temp);
        }

        void MakeKeys(in RecordTable table, int pageCount, int levels, ulong* keys)
        {
            int shift = Cube.SideLog2 - levels;
            int stride = Layout.StrideBytes;
            for (int p = 0; p < pageCount; p++)
            {
                byte* record = RecordPages.RecordsOf(table.Pages[p]);
                int count = table.Pages[p]->Count;
                for (int i = 0; i < count; i++, record += stride)
                {
                    var place = Layout.PlaceOf(record) - Cube.Corner;
                    keys[i] = Morton.Encode((uint)(place.X >> shift), (uint)(place.Y >> shift), (uint)(place.Z >> shift));
                }
                keys += count;
            }
        }

        /// <summary>Counts and distributes by the first digit; what is left of the key goes above the record's number.</summary>
        static void Distribute(in RecordTable table, int pageCount, ulong* keys, ulong* to, int count, int restBits, int keptBits,
            int numberBits, int* start)
        {
            int buckets = 1 << FirstDigitBits;
            UnsafeUtility.MemClear(start, (buckets + 1) * sizeof(int));
            for (int i = 0; i < count; i++)
                start[keys[i] >> restBits]++;
            int sum = 0;
            for (int b = 0; b <= buckets; b++)
            {
                int with = start[b];
                start[b] = sum;
                sum += with;
            }

            int dropped = restBits - keptBits;
            ulong mask = keptBits == 64 ? ulong.MaxValue : (1UL << keptBits) - 1;
            for (int p = 0; p < pageCount; p++)
            {
                ulong number = (ulong)p << RecordPages.RecordsPerPageLog2;
                int inPage = table.Pages[p]->Count;
                for (int i = 0; i < inPage; i++)
                    to[start[keys[i] >> restBits]++] = keptBits == 0 ? number + (ulong)i
                        : (keys[i] >> dropped & mask) << numberBits | number + (ulong)i;
                keys += inPage;
            }
            for (int b = buckets; b > 0; b--)
                start[b] = start[b - 1];
            start[0] = 0;
        }

        static void SortBucket(in RecordTable table, ulong* keys, ulong* scratch, uint* order, int count, int numberBits,
            int keptBits)
        {
            ulong* sorted = count <= 48
                ? InsertionSort(keys, count)
                : RadixSort(keys, scratch, count, numberBits, keptBits, count < 8192 ? 8 : 11);
            ulong numberMask = (1UL << numberBits) - 1;
            for (int i = 0; i < count; i++)
                order[i] = (uint)(sorted[i] & numberMask);
            for (int i = 1; i < count; i++)
            {
                if ((sorted[i - 1] ^ sorted[i]) > numberMask)
                    continue;
                int first = i - 1;
                while (i < count && (sorted[first] ^ sorted[i]) <= numberMask)
                    i++;
                table.Sort(order + first, i - first);
            }
        }

        static ulong* InsertionSort(ulong* keys, int count)
        {
            for (int i = 1; i < count; i++)
            {
                ulong moved = keys[i];
                int at = i;
                for (; at > 0 && keys[at - 1] > moved; at--)
                    keys[at] = keys[at - 1];
                keys[at] = moved;
            }
            return keys;
        }

        /// <returns>Where the sorted keys are: one of the two.</returns>
        static ulong* RadixSort(ulong* keys, ulong* scratch, int count, int firstBit, int bits, int digitBits)
        {
            ulong or = 0, and = ulong.MaxValue;
            for (int i = 0; i < count; i++)
            {
                or |= keys[i];
                and &= keys[i];
            }
            ulong differs = or ^ and;
            int values = 1 << digitBits;
            ulong mask = (ulong)values - 1;
            int* start = stackalloc int[2048];
            for (int bit = firstBit; bit < firstBit + bits; bit += digitBits)
            {
                if ((differs >> bit & mask) == 0)
                    continue;
                UnsafeUtility.MemClear(start, values * sizeof(int));
                for (int i = 0; i < count; i++)
                    start[keys[i] >> bit & mask]++;
                int sum = 0;
                for (int v = 0; v < values; v++)
                {
                    int with = start[v];
                    start[v] = sum;
                    sum += with;
                }
                for (int i = 0; i < count; i++)
                {
                    ulong key = keys[i];
                    scratch[start[key >> bit & mask]++] = key;
                }
                ulong* swap = keys;
                keys = scratch;
                scratch = swap;
            }
            return keys;
        }
    }
}
