using FastPoints.Partition;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;
using Stage = FastPoints.Records.OrderScratch.Stage;

namespace FastPoints.Records
{
    /// <summary>Orders a chunk's records along the Morton curve, those at one place by their content, so that the order is the
    /// same however they came.</summary>
    /// <remarks>
    /// The first digit takes the top three octree levels; its buckets fit a core's cache and are sorted least significant digit
    /// first, as one number each:
    /// <code>
    /// bit 63 ........ n      n - 1 ........ 0
    ///     Morton bits left   record number
    /// </code>
    /// Where a chunk has more Morton bits than that leaves room for (a few points in a vast cube), and at equal places, the
    /// runs that are equal so far are sorted by comparing records. One run of the job is a slice: it is run until it is done.
    /// </remarks>
    [BurstCompile]
    internal unsafe struct OrderChunkJob : IJob
    {
        /// <summary>A slice takes about 4 ms at most, unless a bucket has more points.</summary>
        public const int PointsOfSlice = 60000;

        /// <summary>How often each point is visited: its key is made, distributed, and sorted in its bucket.</summary>
        public const int Looks = 3;

        public const int Buckets = 1 << FirstDigitBits;
        const int FirstDigitBits = 9;
        const int FewRecords = 4096;

        public RecordPages Pages;
        public RecordLayout Layout;
        public GridCube Cube;

        /// <summary>Its <see cref="OrderScratch.Now"/> is reset before the first slice.</summary>
        public OrderScratch Scratch;

        /// <summary>About this many points are visited in one run.</summary>
        public int PointsPerSlice;

        /// <summary>Out: numbers of the records in order.</summary>
        public NativeArray<uint> Order;

        public SliceTimes Slices;

        OrderScratch.State m_now;
        long m_budget;

        public void Execute()
        {
            if (Scratch.IsDone)
                return;
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        int Count => (int)Pages.Count;
        int Levels => math.min(Cube.SideLog2, Morton.BitsPerAxis);
        int KeyBits => 3 * Levels;
        int NumberBits => 64 - math.lzcnt((ulong)Pages.PageCount * RecordPages.RecordsPerPage - 1);

        // Bits of the key in the first digit and below it, and those of the latter that fit above the number.
        int FirstBits => Count < FewRecords ? 0 : math.min(KeyBits, FirstDigitBits);
        int RestBits => KeyBits - FirstBits;
        int KeptBits => math.min(RestBits, 64 - NumberBits);

        void Run()
        {
            m_now = Scratch.Now.Value;
            m_budget = PointsPerSlice;
            if (m_now.Stage == Stage.Start)
                Start();
            var table = new RecordTable
            {
                Pages = (RecordPages.Page**)Scratch.PageTable.GetUnsafePtr(),
                Layout = Layout,
                Corner = Cube.Corner,
            };
            if (m_now.Stage == Stage.MakeKeys)
                MakeKeys(table);
            if (m_now.Stage == Stage.Distribute)
                Distribute(table);
            if (m_now.Stage == Stage.Sort)
                Sort(table);
            Scratch.Now.Value = m_now;
        }

        void Start()
        {
            Scratch.PageTable.Clear();
            for (var page = Pages.First; page != null; page = page->Next)
                Scratch.PageTable.Add((ulong)page);
            UnsafeUtility.MemClear(Scratch.FirstOfBucket.GetUnsafePtr(), (Buckets + 1) * sizeof(int));
            m_now = new OrderScratch.State { Stage = Stage.MakeKeys };
        }

        /// <summary>Makes keys and counts them by their first digit.</summary>
        void MakeKeys(in RecordTable table)
        {
            int shift = Cube.SideLog2 - Levels, restBits = RestBits, stride = Layout.StrideBytes;
            var countOfBucket = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            var keys = (ulong*)Scratch.Keys.GetUnsafePtr() + m_now.Record;
            for (; m_now.At < Pages.PageCount; m_now.At++)
            {
                if (m_budget <= 0)
                    return;
                byte* record = RecordPages.RecordsOf(table.Pages[m_now.At]);
                int count = table.Pages[m_now.At]->Count;
                for (int i = 0; i < count; i++, record += stride)
                {
                    var place = Layout.PlaceOf(record) - Cube.Corner;
                    ulong key = Morton.Encode((uint)(place.X >> shift), (uint)(place.Y >> shift), (uint)(place.Z >> shift));
                    keys[i] = key;
                    countOfBucket[key >> restBits]++;
                }
                keys += count;
                m_now.Record += count;
                m_budget -= count;
            }
            int sum = 0;
            for (int b = 0; b <= Buckets; b++)
            {
                int with = countOfBucket[b];
                countOfBucket[b] = sum;
                sum += with;
            }
            m_now = new OrderScratch.State { Stage = Stage.Distribute };
        }

        /// <summary>Distributes by the first digit; the rest of the key goes above the record's number.</summary>
        void Distribute(in RecordTable table)
        {
            int restBits = RestBits, keptBits = KeptBits, numberBits = NumberBits, dropped = restBits - keptBits;
            ulong mask = keptBits == 64 ? ulong.MaxValue : (1UL << keptBits) - 1;
            var next = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            var keys = (ulong*)Scratch.Keys.GetUnsafePtr() + m_now.Record;
            var to = (ulong*)Scratch.Sorted.GetUnsafePtr();
            for (; m_now.At < Pages.PageCount; m_now.At++)
            {
                if (m_budget <= 0)
                    return;
                ulong number = (ulong)m_now.At << RecordPages.RecordsPerPageLog2;
                int count = table.Pages[m_now.At]->Count;
                for (int i = 0; i < count; i++)
                    to[next[keys[i] >> restBits]++] = keptBits == 0 ? number + (ulong)i
                        : (keys[i] >> dropped & mask) << numberBits | number + (ulong)i;
                keys += count;
                m_now.Record += count;
                m_budget -= count;
            }
            // Each start has moved to its end, which is the start of the next one.
            for (int b = Buckets; b > 0; b--)
                next[b] = next[b - 1];
            next[0] = 0;
            m_now = new OrderScratch.State { Stage = Stage.Sort };
        }

        void Sort(in RecordTable table)
        {
            var start = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            var keys = (ulong*)Scratch.Sorted.GetUnsafePtr();
            var scratch = (ulong*)Scratch.Keys.GetUnsafePtr();
            var order = (uint*)Order.GetUnsafePtr();
            for (; m_now.At < Buckets; m_now.At++)
            {
                if (m_budget <= 0)
                    return;
                int first = start[m_now.At], count = start[m_now.At + 1] - first;
                if (count > 0)
                    SortBucket(table, keys + first, scratch + first, order + first, count, NumberBits, KeptBits);
                m_budget -= count;
            }
            m_now.Stage = Stage.Done;
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

        /// <returns>The array with the sorted keys: one of the two.</returns>
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
