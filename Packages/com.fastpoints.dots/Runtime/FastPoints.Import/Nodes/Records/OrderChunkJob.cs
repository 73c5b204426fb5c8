using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;
using Stage = FastPoints.Nodes.OrderScratch.Stage;

namespace FastPoints.Nodes
{
    /// <summary>Copies a chunk's records in order along the Morton curve, at one position by their content, so that the
    /// order is independent of that of arrival; and prepares the sampling: where cubes end in the order, and each
    /// record's priority.</summary>
    /// <remarks>
    /// Whole records are distributed by the top octree levels; each bucket fits a core's cache and is sorted there, as one number
    /// a record:
    /// <code>
    /// bit 63 ........ n      n - 1 ........ 0
    ///     Morton bits left   record of the bucket
    /// </code> Its top differing bits are sorted by digits, which leaves few records out of order. If a chunk has more
    /// Morton bits than fit (a few points in a vast cube), and at equal positions, groups that are equal so far are
    /// sorted by comparing records. Each execution of the job is a slice: it is repeated until it is done.
    /// </remarks>
    [BurstCompile]
    internal unsafe struct OrderChunkJob : IJob
    {
        /// <summary>A slice takes about 4 ms at most, unless a bucket's sort takes longer. Costs are about nanoseconds.</summary>
        public const int CostOfSlice = 2500000;

        const int CostOfCount = 8;
        const int CostOfMove = 10;
        const int CostOfKey = 10;
        const int CostOfSort = 20;
        const int CostOfEmit = 20;

        const int CostOfTouch = 3000;
        const int TouchedBytes = 4096;

        public const int MaxBuckets = 1 << 3 * MaxLevels;
        const int MaxLevels = 4;
        const int PointsOfBucket = 2048; // Points to a bucket, in a surface: a level has four times the buckets.

        // Below this, digits are shorter: counters would take as long as the points.
        const int FewPoints = 2048;
        const int LongDigitBits = 11;
        const int ShortDigitBits = 8;
        const int InsertedPoints = 48;
        const int PointsOfBatch = 256; // This many records are copied, then examined while they are in the cache.

        public RecordPages Pages;
        public RecordLayout Layout;
        public GridCube Cube;
        public OrderScratch Scratch; // Its OrderScratch.Progress is reset before the first slice.
        public NativeArray<uint> BucketOfPoint; // Scratch: the bucket of each record, as they came.

        public int CostPerSlice;

        public NativeArray<byte> Records;

        /// <summary>Out: for each point, log2 of the side of the smallest cube with it and the previous point; 255 for the first
        /// one.</summary>
        public NativeArray<byte> CommonCubeLog2;
        public NativeArray<uint> Priority; // Out: for each point, the upper half of its hash.
        public NativeReference<ulong> Checksum; // Out: the sum of the hashes.

        public SliceTimes SliceTimes;

        [NativeDisableUnsafePtrRestriction] byte* m_records;
        OrderScratch.State m_state;
        long m_budget;

        public void Execute()
        {
            if (Scratch.IsDone)
                return;
            long begin = SliceTimes.Begin();
            Run();
            SliceTimes.End(begin);
        }

        int Count => (int)Pages.RecordCount;
        long Bytes => (long)Count * Layout.StrideBytes;

        public long Cost =>
            Count * (long)(CostOfCount + CostOfMove + CostOfKey + CostOfSort + CostOfEmit) +
            Bytes / TouchedBytes * CostOfTouch;

        // Levels of the octree above the buckets, and those whose bits a key has.
        int BucketLevels
        {
            get
            {
                int levels = 0;
                while (levels < MaxLevels && levels < Cube.SideLog2 && Count >> 2 * levels > PointsOfBucket)
                    levels++;
                return levels;
            }
        }

        // Positions are whole numbers of less than 32 bits from the corner.
        bool IsNarrow => !Layout.IsWide && Cube.SideLog2 <= 31;

        uint3 CornerOffset
        {
            get
            {
                var corner = Cube.Corner - Layout.Base;
                return new uint3((uint)corner.X, (uint)corner.Y, (uint)corner.Z);
            }
        }

        int Levels => math.min(Cube.SideLog2, Morton.BitsPerAxis);

        void Run()
        {
            m_state = Scratch.Progress.Value;
            m_budget = CostPerSlice;
            m_records = (byte*)Records.GetUnsafePtr();
            if (m_state.Stage == Stage.Start)
                Start();
            if (m_state.Stage == Stage.Touch)
                Touch();
            if (m_state.Stage == Stage.Count)
                CountBuckets();
            if (m_state.Stage == Stage.Distribute)
                Distribute();
            while (m_budget > 0 && m_state.Stage < Stage.Done)
            {
                if (m_state.Stage == Stage.Keys)
                    MakeKeys();
                else if (m_state.Stage == Stage.Sort)
                    SortBucket();
                else
                    Emit();
            }
            Scratch.Progress.Value = m_state;
        }

        void Start()
        {
            UnsafeUtility.MemClear(Scratch.FirstOfBucket.GetUnsafePtr(), (MaxBuckets + 1) * sizeof(int));
            Checksum.Value = 0;
            m_state = new OrderScratch.State { Stage = Stage.Touch, Page = Pages.First };
        }

        /// <summary>The system commits memory on the first write. Records come in no order: without this, one slice
        /// would commit nearly all of it.</summary>
        void Touch()
        {
            for (; m_state.Touched < Bytes; m_state.Touched += TouchedBytes, m_budget -= CostOfTouch)
            {
                if (m_budget <= 0)
                    return;
                m_records[m_state.Touched] = 0;
            }
            m_state.Stage = Stage.Count;
        }

        void CountBuckets()
        {
            int shift = Cube.SideLog2 - BucketLevels, stride = Layout.StrideBytes;
            var countOfBucket = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            var bucketOf = (uint*)BucketOfPoint.GetUnsafePtr() + m_state.Point;
            for (; m_state.Page != null; m_state.Page = m_state.Page->Next)
            {
                if (m_budget <= 0)
                    return;
                byte* record = RecordPages.RecordsOf(m_state.Page);
                int count = m_state.Page->Count;
                if (IsNarrow)
                    FindBuckets(record, count, shift, bucketOf);
                for (int i = 0; i < count; i++, record += stride)
                {
                    if (!IsNarrow)
                        bucketOf[i] = (uint)CodeOf(record, shift);
                    countOfBucket[bucketOf[i]]++;
                }
                bucketOf += count;
                m_state.Point += count;
                m_budget -= (long)count * CostOfCount;
            }
            int sum = 0;
            for (int b = 0; b <= MaxBuckets; b++)
            {
                int records = countOfBucket[b];
                countOfBucket[b] = sum;
                sum += records;
            }
            m_state = new OrderScratch.State { Stage = Stage.Distribute, Page = Pages.First };
        }

        void FindBuckets(byte* records, int count, int shift, uint* bucketOf)
        {
            uint* x = stackalloc uint[PointsOfBatch];
            uint* y = stackalloc uint[PointsOfBatch];
            uint* z = stackalloc uint[PointsOfBatch];
            for (int first = 0; first < count; first += PointsOfBatch)
            {
                int length = math.min(PointsOfBatch, count - first);
                Layout.LoadNarrowPositions(records + first * Layout.StrideBytes, length, x, y, z);
                Morton.EncodeShort(x, y, z, length, new MortonCells(CornerOffset, shift), bucketOf + first);
            }
        }

        ulong CodeOf(byte* record, int shift)
        {
            var position = Layout.PositionOf(record) - Cube.Corner;
            return Morton.Encode((uint)(position.X >> shift), (uint)(position.Y >> shift), (uint)(position.Z >> shift));
        }

        void Distribute()
        {
            int stride = Layout.StrideBytes;
            var next = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            var bucketOf = (uint*)BucketOfPoint.GetUnsafePtr() + m_state.Point;
            for (; m_state.Page != null; m_state.Page = m_state.Page->Next)
            {
                if (m_budget <= 0)
                    return;
                byte* record = RecordPages.RecordsOf(m_state.Page);
                int count = m_state.Page->Count;
                for (int i = 0; i < count; i++, record += stride)
                    RecordLayout.Copy(record, m_records + (long)next[bucketOf[i]]++ * stride, stride);
                bucketOf += count;
                m_state.Point += count;
                m_budget -= (long)count * CostOfMove;
            }
            // Each start has moved to its end, which is the start of the next one.
            for (int b = MaxBuckets; b > 0; b--)
                next[b] = next[b - 1];
            next[0] = 0;
            m_state = new OrderScratch.State { Stage = Stage.Keys };
        }

        /// <summary>Copies some records of the next bucket that has any, and makes their keys.</summary>
        void MakeKeys()
        {
            var start = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            while (m_state.Bucket < MaxBuckets && start[m_state.Bucket] == start[m_state.Bucket + 1])
                m_state.Bucket++;
            if (m_state.Bucket == MaxBuckets)
            {
                Scratch.Trim();
                m_state.Stage = Stage.Done;
                return;
            }
            int first = start[m_state.Bucket], count = start[m_state.Bucket + 1] - first, stride = Layout.StrideBytes;
            if (m_state.Point == 0)
            {
                Scratch.Reserve(count, stride);
                m_state.AnyBits = 0;
                m_state.CommonBits = ulong.MaxValue;
            }
            int numberBits = NumberBitsOf(count), shift = Cube.SideLog2 - Levels, restBits = 3 * (Levels - BucketLevels);
            int dropped = math.max(0, restBits + numberBits - 64);
            ulong mask = (1UL << restBits) - 1, or = m_state.AnyBits, and = m_state.CommonBits;
            ulong* keys = Scratch.Keys.GetUnsafePtr();
            uint* x = stackalloc uint[PointsOfBatch];
            uint* y = stackalloc uint[PointsOfBatch];
            uint* z = stackalloc uint[PointsOfBatch];
            for (; m_state.Point < count && m_budget > 0; m_state.Point += PointsOfBatch)
            {
                int end = math.min(count, m_state.Point + PointsOfBatch);
                byte* record = Scratch.Bucket.GetUnsafePtr() + (long)m_state.Point * stride;
                UnsafeUtility.MemCpy(record, m_records + (long)(first + m_state.Point) * stride,
                    (long)(end - m_state.Point) * stride);
                if (IsNarrow)
                {
                    Layout.LoadNarrowPositions(record, end - m_state.Point, x, y, z);
                    Morton.Encode(x, y, z, end - m_state.Point, new MortonCells(CornerOffset, shift), keys + m_state.Point);
                }
                for (int i = m_state.Point; i < end; i++, record += stride)
                {
                    ulong key = IsNarrow ? keys[i] : CodeOf(record, shift);
                    key = (key & mask) >> dropped << numberBits | (uint)i;
                    or |= key;
                    and &= key;
                    keys[i] = key;
                }
                m_budget -= PointsOfBatch * CostOfKey;
            }
            m_state.AnyBits = or;
            m_state.CommonBits = and;
            if (m_state.Point >= count)
                m_state.Stage = Stage.Sort;
        }

        void SortBucket()
        {
            var start = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            int count = start[m_state.Bucket + 1] - start[m_state.Bucket];
            // A bucket that takes longer than is left gets its own slice.
            long cost = (long)count * CostOfSort;
            if (cost > m_budget && m_budget < CostPerSlice)
            {
                m_budget = 0;
                return;
            }
            ulong* keys = Scratch.Keys.GetUnsafePtr();
            m_state.IsSwapped = Sort(keys, keys + count, count);
            m_state.Point = 0;
            m_state.Stage = Stage.Emit;
            m_budget -= cost;
        }

        /// <returns>Whether the sorted keys are in the scratch.</returns>
        bool Sort(ulong* keys, ulong* scratch, int count)
        {
            int numberBits = NumberBitsOf(count);
            ulong numberMask = (1UL << numberBits) - 1;
            int top = 64 - math.lzcnt((m_state.AnyBits ^ m_state.CommonBits) & ~numberMask);
            int digit = count < FewPoints ? ShortDigitBits : LongDigitBits;
            // Two long digits, or three short ones, leave few records of one prefix.
            int prefix = count <= InsertedPoints ? top : math.max(numberBits, top - (count < FewPoints ? 3 : 2) * digit);
            ulong* sorted = RadixSort(keys, scratch, count, prefix, top, digit);
            if (!TryInsertionSort(sorted, count))
                sorted = RadixSort(sorted, sorted == keys ? scratch : keys, count, numberBits, top, digit);
            var table = new RecordTable { Records = Scratch.Bucket.GetUnsafePtr(), Layout = Layout, Corner = Cube.Corner };
            for (int i = 1; i < count; i++)
            {
                if ((sorted[i - 1] ^ sorted[i]) > numberMask)
                    continue;
                int first = i - 1;
                while (i < count && (sorted[first] ^ sorted[i]) <= numberMask)
                    i++;
                table.Sort(sorted + first, i - first, numberMask);
            }
            return sorted != keys;
        }

        static int NumberBitsOf(int count) => 32 - math.lzcnt((uint)count);

        void Emit()
        {
            var start = (int*)Scratch.FirstOfBucket.GetUnsafePtr();
            int first = start[m_state.Bucket], count = start[m_state.Bucket + 1] - first;
            int stride = Layout.StrideBytes;
            ulong numberMask = (1UL << NumberBitsOf(count)) - 1;
            ulong* sorted = Scratch.Keys.GetUnsafePtr() + (m_state.IsSwapped ? count : 0);
            byte* records = Scratch.Bucket.GetUnsafePtr();
            var inputs = new SampleInputs
            {
                CommonCubeLog2 = (byte*)CommonCubeLog2.GetUnsafePtr(),
                Priority = (uint*)Priority.GetUnsafePtr(),
            };
            ulong sum = Checksum.Value;
            for (; m_state.Point < count && m_budget > 0; m_state.Point += PointsOfBatch)
            {
                int end = math.min(count, m_state.Point + PointsOfBatch);
                byte* to = m_records + (long)(first + m_state.Point) * stride;
                for (int i = m_state.Point; i < end; i++, to += stride)
                    RecordLayout.Copy(records + (long)(sorted[i] & numberMask) * stride, to, stride);
                sum += inputs.Prepare(m_records, first + m_state.Point, first + end, Layout, Cube.Corner);
                m_budget -= PointsOfBatch * CostOfEmit;
            }
            Checksum.Value = sum;
            if (m_state.Point < count)
                return;
            m_state.Bucket++;
            m_state.Point = 0;
            m_state.Stage = Stage.Keys;
        }

        /// <returns>False if it gave up, since many keys are far from their index.</returns>
        static bool TryInsertionSort(ulong* keys, int count)
        {
            long budget = 8L * count + InsertedPoints * InsertedPoints;
            for (int i = 1; i < count; i++)
            {
                ulong moved = keys[i];
                if (keys[i - 1] <= moved)
                    continue;
                int at = i;
                for (; at > 0 && keys[at - 1] > moved; at--)
                    keys[at] = keys[at - 1];
                keys[at] = moved;
                budget -= i - at;
                if (budget < 0)
                    return false;
            }
            return true;
        }

        /// <summary>Sorts by some of the keys' bits.</summary>
        /// <returns>The array with the sorted keys: one of the two.</returns>
        static ulong* RadixSort(ulong* keys, ulong* scratch, int count, int firstBit, int endBit, int digitBits)
        {
            int values = 1 << digitBits;
            ulong mask = (ulong)values - 1;
            int* start = stackalloc int[1 << LongDigitBits];
            for (int bit = firstBit; bit < endBit; bit += digitBits)
            {
                UnsafeUtility.MemClear(start, values * sizeof(int));
                for (int i = 0; i < count; i++)
                    start[keys[i] >> bit & mask]++;
                int sum = 0;
                for (int v = 0; v < values; v++)
                {
                    int keysWithDigit = start[v];
                    start[v] = sum;
                    sum += keysWithDigit;
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

    internal unsafe struct SampleInputs
    {
        public byte* CommonCubeLog2; // By point: MortonOrder.CommonCubeLog2 of it and the previous one.
        public uint* Priority;

        /// <summary>Finds, from records in order, where cubes end, and priorities.</summary>
        /// <param name="first">First point to process; the one before it is read.</param>
        /// <returns>The sum of the records' hashes.</returns>
        public readonly ulong Prepare(byte* records, int first, int end, RecordLayout layout, Grid3 corner)
        {
            byte* commonCubeLog2 = CommonCubeLog2;
            uint* priority = Priority;
            ulong sum = 0;
            int stride = layout.StrideBytes;
            byte* record = records + (long)first * stride;
            var before = layout.PositionOf(first > 0 ? record - stride : record) - corner;
            for (int i = first; i < end; i++, record += stride)
            {
                var position = layout.PositionOf(record);
                ulong hash = Store.RecordHash.Of(position, layout.AttributesOf(record), layout.AttributeBytes,
                    Store.RecordHash.ChecksumSeed);
                sum += hash;
                priority[i] = (uint)(hash >> 32);
                position -= corner;
                commonCubeLog2[i] = (byte)MortonOrder.CommonCubeLog2(before, position);
                before = position;
            }
            if (first == 0)
                commonCubeLog2[0] = byte.MaxValue;
            return sum;
        }
    }
}
