using FastPoints.Files;
using FastPoints.Partition;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Records
{
    /// <summary>Turns one batch of columns into records, grouped by chunk, and collects statistics of the points: bounds,
    /// attribute ranges, checksum, and how many have no position.</summary>
    [BurstCompile]
    internal unsafe struct GroupRecordsJob : IJob
    {
        /// <summary>This many records are made one behind another, in the cache, before each goes to its chunk.</summary>
        public const int RunPoints = 256;

        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;
        [ReadOnly] public NativeArray<RecordField> Fields;
        public SourceGrid Grid;
        public RecordLayout Layout;
        public ChunkFinder Chunks;
        [ReadOnly] public NativeArray<int> ChunkOfCell;

        /// <summary>Has room for the batch's records.</summary>
        public NativeArray<byte> Records;

        /// <summary>Start of each chunk's records, with one more entry. The chunk for points outside comes before the last
        /// entry.</summary>
        public NativeArray<int> FirstOfChunk;

        /// <summary>Scratch, indexed by point.</summary>
        public NativeArray<int> ChunkOfPoint;

        /// <summary>Scratch: the records of a run.</summary>
        public NativeArray<byte> RunRecords;
        public NativeReference<PointStatistics> Statistics;
        public NativeArray<AttributeStatistics> Attributes;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int count = Decoded.Value.Points;
            var statistics = Statistics.Value;
            var bytes = (byte*)Columns.GetUnsafeReadOnlyPtr();
            var records = (byte*)Records.GetUnsafePtr();
            var chunkOfPoint = (int*)ChunkOfPoint.GetUnsafePtr();
            var first = (int*)FirstOfChunk.GetUnsafePtr();
            int stride = Layout.StrideBytes;

            FindChunks(bytes, count, chunkOfPoint, first, ref statistics);
            int kept = Order(count, chunkOfPoint, first);
            statistics.Count += kept;

            // From here on a point's entry is the place of its record, or -1.
            var run = (byte*)RunRecords.GetUnsafePtr();
            int padding = Layout.PositionBytes + Layout.AttributeBytes - sizeof(uint);
            var found = (AttributeStatistics*)Attributes.GetUnsafePtr();
            ulong sum = 0;
            for (int done = 0; done < count; done += RunPoints)
            {
                int points = math.min(RunPoints, count - done);
                int* placeOfPoint = chunkOfPoint + done;
                WritePlaces(bytes, done, points, run);
                for (int i = 0; i < points && Fields.Length > 0; i++)
                    *(uint*)(run + i * stride + padding) = 0;
                for (int f = 0; f < Fields.Length; f++)
                {
                    var field = Fields[f];
                    CopyColumn(bytes + field.Column.OffsetBytes + (long)done * field.Column.Type.SizeOf(), field.Column.Type,
                        points, placeOfPoint, run + Layout.PositionBytes + field.RecordOffset, stride,
                        ref found[field.Attribute]);
                }
                for (int i = 0; i < points; i++)
                {
                    if (placeOfPoint[i] < 0)
                        continue;
                    byte* record = run + i * stride;
                    sum += Layout.HashOf(record, Store.RecordHash.ChecksumSeed);
                    RecordLayout.Copy(record, records + (long)placeOfPoint[i] * stride, stride);
                }
            }
            statistics.Checksum += sum;
            Statistics.Value = statistics;
            Slices.End(begin);
        }

        void FindChunks(byte* bytes, int count, int* chunkOfPoint, int* countOfChunk, ref PointStatistics statistics)
        {
            UnsafeUtility.MemClear(countOfChunk, (long)FirstOfChunk.Length * sizeof(int));
            long* x = stackalloc long[RunPoints];
            long* y = stackalloc long[RunPoints];
            long* z = stackalloc long[RunPoints];
            var chunkOfCell = (int*)ChunkOfCell.GetUnsafeReadOnlyPtr();
            Grid3 min = statistics.Min, max = statistics.Max;
            for (int done = 0; done < count; done += RunPoints)
            {
                int run = math.min(RunPoints, count - done);
                LoadRun(bytes, done, run, x, y, z, ref statistics.WorstLossSteps);
                for (int i = 0; i < run; i++)
                {
                    if (x[i] == SourceGrid.Nowhere || y[i] == SourceGrid.Nowhere || z[i] == SourceGrid.Nowhere)
                    {
                        chunkOfPoint[done + i] = -1;
                        statistics.LeftOut++;
                        continue;
                    }
                    min.X = math.min(min.X, x[i]);
                    min.Y = math.min(min.Y, y[i]);
                    min.Z = math.min(min.Z, z[i]);
                    max.X = math.max(max.X, x[i]);
                    max.Y = math.max(max.Y, y[i]);
                    max.Z = math.max(max.Z, z[i]);
                    int chunk = Chunks.ChunkOf(chunkOfCell, x[i], y[i], z[i]);
                    chunkOfPoint[done + i] = chunk;
                    countOfChunk[chunk]++;
                }
            }
            statistics.Min = min;
            statistics.Max = max;
        }

        /// <summary>Turns counts into starts, and each point's chunk into the place of its record.</summary>
        int Order(int count, int* chunkOfPoint, int* first)
        {
            int chunks = FirstOfChunk.Length - 1;
            int sum = 0;
            for (int c = 0; c < chunks; c++)
            {
                int with = first[c];
                first[c] = sum;
                sum += with;
            }
            for (int i = 0; i < count; i++)
                if (chunkOfPoint[i] >= 0)
                    chunkOfPoint[i] = first[chunkOfPoint[i]]++;
            // Each start has moved to its end, which is the start of the next one.
            for (int c = chunks; c > 0; c--)
                first[c] = first[c - 1];
            first[0] = 0;
            return sum;
        }

        void WritePlaces(byte* bytes, int first, int count, byte* records)
        {
            long* x = stackalloc long[RunPoints];
            long* y = stackalloc long[RunPoints];
            long* z = stackalloc long[RunPoints];
            double ignored = 0;
            int stride = Layout.StrideBytes;
            LoadRun(bytes, first, count, x, y, z, ref ignored);
            for (int i = 0; i < count; i++)
                Layout.SetPlace(records + i * stride, x[i], y[i], z[i]);
        }

        void LoadRun(byte* bytes, int first, int count, long* x, long* y, long* z, ref double worstLoss)
        {
            SourceGrid.ToGrid(Grid.X, bytes, X, first, count, x, ref worstLoss);
            SourceGrid.ToGrid(Grid.Y, bytes, Y, first, count, y, ref worstLoss);
            SourceGrid.ToGrid(Grid.Z, bytes, Z, first, count, z, ref worstLoss);
        }

        static void CopyColumn(byte* from, AttributeType type, int count, int* placeOfPoint, byte* to, int stride,
            ref AttributeStatistics statistics)
        {
            if (type == AttributeType.UInt16)
            {
                CopyShorts((ushort*)from, count, placeOfPoint, to, stride, ref statistics);
                return;
            }
            ulong min = statistics.Min, max = statistics.Max, or = statistics.Or;
            int size = type.SizeOf();
            for (int i = 0; i < count; i++)
            {
                if (placeOfPoint[i] < 0)
                    continue;
                byte* value = from + (long)i * size;
                byte* target = to + i * stride;
                switch (size)
                {
                    case 1: *target = *value; break;
                    case 2: *(ushort*)target = *(ushort*)value; break;
                    case 4: *(uint*)target = *(uint*)value; break;
                    default: *(ulong*)target = *(ulong*)value; break;
                }
                ulong ordered = Store.OrderedBits.Load(value, type);
                min = math.min(min, ordered);
                max = math.max(max, ordered);
                or |= ordered;
            }
            statistics.Min = min;
            statistics.Max = max;
            statistics.Or = or;
        }

        /// <summary>Copies the usual type of colours and intensity, whose halves are examined.</summary>
        static void CopyShorts(ushort* from, int count, int* placeOfPoint, byte* to, int stride,
            ref AttributeStatistics statistics)
        {
            uint min = ushort.MaxValue, max = 0, or = 0, notDoubled = statistics.NotDoubled;
            int copied = 0;
            for (int i = 0; i < count; i++)
            {
                if (placeOfPoint[i] < 0)
                    continue;
                uint value = from[i];
                *(ushort*)(to + i * stride) = (ushort)value;
                min = math.min(min, value);
                max = math.max(max, value);
                or |= value;
                notDoubled |= value >> 8 ^ value & 0xFF;
                copied++;
            }
            if (copied == 0)
                return;
            statistics.Min = math.min(statistics.Min, min);
            statistics.Max = math.max(statistics.Max, max);
            statistics.Or |= or;
            statistics.NotDoubled = notDoubled;
        }
    }

    /// <summary>A copy from a column of a batch to a place in a record. Blittable.</summary>
    internal struct RecordField
    {
        public PointColumn Column;

        /// <summary>Offset from the record's first attribute byte.</summary>
        public int RecordOffset;

        /// <summary>Index of the attribute in the cloud's schema.</summary>
        public int Attribute;
    }
}
