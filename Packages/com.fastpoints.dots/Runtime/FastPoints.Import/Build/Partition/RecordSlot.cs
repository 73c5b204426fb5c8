using System;
using FastPoints.Nodes;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>The memory that one block in flight needs to become records, grouped by chunk, and the statistics of its points
    /// so far.</summary>
    internal sealed class RecordSlot : IDisposable
    {
        readonly RecordLayout m_layout;
        readonly PartitionMap m_map;
        NativeArray<RecordField> m_fields;
        NativeArray<int> m_chunkOfPoint;
        NativeArray<byte> m_batchRecords;

        public RecordSlot(int capacity, PointSchema attributes, RecordLayout layout, PartitionMap map, PointBatch batch)
        {
            m_layout = layout;
            m_map = map;
            capacity = Math.Max(1, capacity);
            Records = new NativeArray<byte>(checked(capacity * layout.StrideBytes), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            FirstOfChunk = new NativeArray<int>(map.Chunks.Length + 2, Allocator.Persistent);
            Statistics = new NativeReference<PointStatistics>(PointStatistics.None, Allocator.Persistent);
            Slices = new SliceTimes(Allocator.Persistent);
            Detached = new NativeList<DetachedRecordPages>(8, Allocator.Persistent);
            m_chunkOfPoint = new NativeArray<int>(capacity, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            m_batchRecords = new NativeArray<byte>(GroupRecordsJob.BatchPoints * layout.StrideBytes, Allocator.Persistent);
            var statistics = new AttributeStatistics[attributes.Count];
            var fields = new RecordField[attributes.Count];
            int offset = 0;
            for (int a = 0; a < fields.Length; a++)
            {
                statistics[a] = AttributeStatistics.None;
                fields[a] = new RecordField
                {
                    Column = batch.Column(batch.Schema.IndexOf(attributes[a].Name)),
                    RecordOffset = offset,
                    Attribute = a,
                };
                offset += attributes[a].Type.SizeOf();
            }
            m_fields = new NativeArray<RecordField>(fields, Allocator.Persistent);
            Attributes = new NativeArray<AttributeStatistics>(statistics, Allocator.Persistent);
        }

        public NativeArray<byte> Records { get; } // The records of the block's points that have a position.

        /// <summary>First record of each chunk, including that for points outside, and one more entry.</summary>
        public NativeArray<int> FirstOfChunk { get; }

        public NativeReference<PointStatistics> Statistics { get; }
        public NativeArray<AttributeStatistics> Attributes { get; }

        public SliceTimes Slices { get; }

        public NativeList<DetachedRecordPages> Detached { get; }

        /// <param name="result">Says how many points the batch has, when <paramref name="decoded"/> completes.</param>
        public JobHandle ScheduleGrouping(PointBatch batch, NativeReference<DecodeResult> result, in SourceToGrid grid,
            JobHandle decoded)
        {
            return new GroupRecordsJob
            {
                SliceTimes = Slices,
                Columns = batch.Bytes,
                Decoded = result,
                Positions = PositionColumns.Of(batch),
                Fields = m_fields,
                Grid = grid,
                Layout = m_layout,
                Chunks = m_map.Finder,
                ChunkOfCell = m_map.ChunkOfCell,
                Records = Records,
                FirstOfChunk = FirstOfChunk,
                ChunkOfPoint = m_chunkOfPoint,
                BatchRecords = m_batchRecords,
                Statistics = Statistics,
                Attributes = Attributes,
            }.Schedule(decoded);
        }

        public PointStatistics TakeStatistics(AttributeStatistics[] attributes)
        {
            var statistics = Statistics;
            var found = statistics.Value;
            statistics.Value = PointStatistics.None;
            var own = Attributes;
            for (int a = 0; a < own.Length; a++)
            {
                attributes[a].Include(own[a]);
                own[a] = AttributeStatistics.None;
            }
            return found;
        }

        public void Dispose()
        {
            if (!m_fields.IsCreated)
                return;
            Records.Dispose();
            FirstOfChunk.Dispose();
            Statistics.Dispose();
            Detached.Dispose();
            Slices.Dispose();
            Attributes.Dispose();
            m_fields.Dispose();
            m_chunkOfPoint.Dispose();
            m_batchRecords.Dispose();
        }
    }

    /// <summary>Turns one batch of columns into records, grouped by chunk, and collects statistics of the points: bounds,
    /// attribute ranges, checksum, and how many have no position.</summary>
    [BurstCompile]
    internal unsafe struct GroupRecordsJob : IJob
    {
        /// <summary>This many records are built one after another, in the cache, before each is copied to its chunk.</summary>
        public const int BatchPoints = 256;

        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        public PositionColumns Positions;
        [ReadOnly] public NativeArray<RecordField> Fields;
        public SourceToGrid Grid;
        public RecordLayout Layout;
        public ChunkFinder Chunks;
        [ReadOnly] public NativeArray<int> ChunkOfCell;

        public NativeArray<byte> Records;

        /// <summary>Start of each chunk's records, with one more entry. The chunk for points outside comes before the last
        /// entry.</summary>
        public NativeArray<int> FirstOfChunk;

        public NativeArray<int> ChunkOfPoint;

        public NativeArray<byte> BatchRecords;
        public NativeReference<PointStatistics> Statistics;
        public NativeArray<AttributeStatistics> Attributes;

        public SliceTimes SliceTimes;

        public void Execute()
        {
            long start = SliceTimes.Begin();
            int count = Decoded.Value.Points;
            var statistics = Statistics.Value;
            var bytes = (byte*)Columns.GetUnsafeReadOnlyPtr();
            var records = (byte*)Records.GetUnsafePtr();
            var chunkOfPoint = (int*)ChunkOfPoint.GetUnsafePtr();
            var first = (int*)FirstOfChunk.GetUnsafePtr();

            FindChunks(bytes, count, chunkOfPoint, first, ref statistics);
            int kept = Order(count, chunkOfPoint, first);
            statistics.Count += kept;

            // From here on a point's entry is the index of its record, or -1.
            var batch = (byte*)BatchRecords.GetUnsafePtr();
            ulong sum = 0;
            int end;
            for (int begin = 0; begin < count; begin = end)
            {
                end = begin + 1;
                if (chunkOfPoint[begin] < 0)
                    continue;
                while (end < count && end - begin < BatchPoints && chunkOfPoint[end] >= 0)
                    end++;
                WriteBatch(bytes, begin, end - begin, batch);
                sum += Scatter(batch, chunkOfPoint + begin, end - begin, records);
            }
            statistics.Checksum += sum;
            Statistics.Value = statistics;
            SliceTimes.End(start);
        }

        void FindChunks(byte* bytes, int count, int* chunkOfPoint, int* countOfChunk, ref PointStatistics statistics)
        {
            UnsafeUtility.MemClear(countOfChunk, (long)FirstOfChunk.Length * sizeof(int));
            var chunkOfCell = (int*)ChunkOfCell.GetUnsafeReadOnlyPtr();
            for (int done = 0; done < count; done += BatchPoints)
            {
                int batch = math.min(BatchPoints, count - done);
                int* chunks = chunkOfPoint + done;
                if (Layout.IsWide || !FindChunksInside(bytes, done, batch, chunkOfCell, chunks, ref statistics))
                    FindChunksAnywhere(bytes, done, batch, chunkOfCell, chunks, ref statistics);
                for (int i = 0; i < batch; i++)
                    if (chunks[i] >= 0)
                        countOfChunk[chunks[i]]++;
            }
        }

        /// <returns>False if some of the points are outside the cube: nothing is done.</returns>
        bool FindChunksInside(byte* bytes, int first, int count, int* chunkOfCell, int* chunks, ref PointStatistics statistics)
        {
            uint* x = stackalloc uint[3 * BatchPoints];
            uint* y = x + BatchPoints, z = y + BatchPoints;
            LoadOffsets(bytes, first, count, x);
            Store.BlockCodec.FindRange(x, count, out uint minX, out uint maxX);
            Store.BlockCodec.FindRange(y, count, out uint minY, out uint maxY);
            Store.BlockCodec.FindRange(z, count, out uint minZ, out uint maxZ);
            Grid3 min = Layout.Base + new Grid3(minX, minY, minZ), max = Layout.Base + new Grid3(maxX, maxY, maxZ);
            if (!Chunks.CanLocateAll(min, max))
                return false;
            statistics.Min = Grid3.Min(statistics.Min, min);
            statistics.Max = Grid3.Max(statistics.Max, max);
            Chunks.ChunksOf(chunkOfCell, x, BatchPoints, count, Layout.Base, chunks);
            return true;
        }

        /// <summary>The same for any points; -1 for those without a position.</summary>
        void FindChunksAnywhere(byte* bytes, int first, int count, int* chunkOfCell, int* chunks, ref PointStatistics statistics)
        {
            long* x = stackalloc long[3 * BatchPoints];
            long* y = x + BatchPoints, z = y + BatchPoints;
            LoadBatch(bytes, first, count, x, ref statistics.MaxRoundingSteps);
            for (int i = 0; i < count; i++)
            {
                chunks[i] = -1;
                if (x[i] == SourceToGrid.InvalidPosition || y[i] == SourceToGrid.InvalidPosition ||
                    z[i] == SourceToGrid.InvalidPosition)
                {
                    statistics.LeftOut++;
                    continue;
                }
                var position = new Grid3(x[i], y[i], z[i]);
                statistics.Min = Grid3.Min(statistics.Min, position);
                statistics.Max = Grid3.Max(statistics.Max, position);
                chunks[i] = Chunks.ChunkOf(chunkOfCell, x[i], y[i], z[i]);
            }
        }

        /// <summary>Turns counts into starts, and each point's chunk into the index of its record.</summary>
        int Order(int count, int* chunkOfPoint, int* first)
        {
            int chunks = FirstOfChunk.Length - 1;
            int sum = 0;
            for (int c = 0; c < chunks; c++)
            {
                int points = first[c];
                first[c] = sum;
                sum += points;
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

        /// <summary>Writes the records of consecutive points that have a position. Padding stays zero.</summary>
        void WriteBatch(byte* bytes, int first, int count, byte* records)
        {
            WritePositions(bytes, first, count, records);
            int stride = Layout.StrideBytes;
            byte* attributes = Layout.AttributesOf(records);
            var found = (AttributeStatistics*)Attributes.GetUnsafePtr();
            for (int f = 0; f < Fields.Length; f++)
            {
                var field = Fields[f];
                var type = field.Column.Type;
                byte* values = field.Column.At(bytes, first);
                CopyColumn(values, type.SizeOf(), count, attributes + field.RecordOffset, stride);
                found[field.Attribute].Include(AttributeStatistics.Of(values, type, count));
            }
        }

        void WritePositions(byte* bytes, int first, int count, byte* records)
        {
            int stride = Layout.StrideBytes;
            if (Layout.IsWide)
            {
                long* wide = stackalloc long[3 * BatchPoints];
                double ignored = 0;
                LoadBatch(bytes, first, count, wide, ref ignored);
                for (int i = 0; i < count; i++)
                    Layout.SetPosition(records + i * stride, wide[i], wide[BatchPoints + i], wide[2 * BatchPoints + i]);
                return;
            }
            uint* x = stackalloc uint[3 * BatchPoints];
            uint* y = x + BatchPoints, z = y + BatchPoints;
            LoadOffsets(bytes, first, count, x);
            for (int i = 0; i < count; i++, records += stride)
            {
                ((uint*)records)[0] = x[i];
                ((uint*)records)[1] = y[i];
                ((uint*)records)[2] = z[i];
            }
        }

        void LoadOffsets(byte* bytes, int first, int count, uint* offsets)
        {
            var (stored, origin) = (Positions, Layout.Base);
            uint* y = offsets + BatchPoints, z = y + BatchPoints;
            SourceToGrid.IntegersToOffsets(Grid.X, stored.X.At(bytes, first), stored.X.Type, count, origin.X, offsets);
            SourceToGrid.IntegersToOffsets(Grid.Y, stored.Y.At(bytes, first), stored.Y.Type, count, origin.Y, y);
            SourceToGrid.IntegersToOffsets(Grid.Z, stored.Z.At(bytes, first), stored.Z.Type, count, origin.Z, z);
        }

        /// <summary>Copies records to their indices.</summary>
        /// <returns>The sum of their hashes.</returns>
        ulong Scatter(byte* batch, int* positions, int count, byte* records)
        {
            var layout = Layout;
            int stride = layout.StrideBytes;
            ulong sum = 0;
            for (int i = 0; i < count; i++, batch += stride)
            {
                sum += layout.HashOf(batch, Store.RecordHash.ChecksumSeed);
                RecordLayout.Copy(batch, records + (long)positions[i] * stride, stride);
            }
            return sum;
        }

        void LoadBatch(byte* bytes, int first, int count, long* positions, ref double loss)
        {
            var stored = Positions;
            SourceToGrid.ToGrid(Grid.X, stored.X.At(bytes, first), stored.X.Type, count, positions, ref loss);
            SourceToGrid.ToGrid(Grid.Y, stored.Y.At(bytes, first), stored.Y.Type, count, positions + BatchPoints, ref loss);
            SourceToGrid.ToGrid(Grid.Z, stored.Z.At(bytes, first), stored.Z.Type, count, positions + 2 * BatchPoints, ref loss);
        }

        static void CopyColumn(byte* from, int size, int count, byte* to, int stride)
        {
            switch (size)
            {
                case 1:
                    for (int i = 0; i < count; i++, to += stride)
                        *to = from[i];
                    return;
                case 2:
                    for (int i = 0; i < count; i++, to += stride)
                        *(ushort*)to = ((ushort*)from)[i];
                    return;
                case 4:
                    for (int i = 0; i < count; i++, to += stride)
                        *(uint*)to = ((uint*)from)[i];
                    return;
                default:
                    for (int i = 0; i < count; i++, to += stride)
                        *(ulong*)to = ((ulong*)from)[i];
                    return;
            }
        }
    }

    internal struct RecordField
    {
        public PointColumn Column;

        public int RecordOffset;

        public int Attribute;
    }
}
