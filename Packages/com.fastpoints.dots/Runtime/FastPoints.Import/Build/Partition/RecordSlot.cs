using System;
using FastPoints.Core;
using FastPoints.Nodes;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

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
        NativeArray<byte> m_runRecords;

        /// <param name="capacity">Points of the largest block.</param>
        /// <param name="attributes">The attributes of records, all of which the batch has.</param>
        /// <param name="batch">The layout of the columns that will come.</param>
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
            m_runRecords = new NativeArray<byte>(GroupRecordsJob.RunPoints * layout.StrideBytes, Allocator.Persistent);
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

        /// <summary>The block's points that have a position.</summary>
        public NativeArray<byte> Records { get; }

        /// <summary>First record of each chunk, including that for points outside, and one more entry.</summary>
        public NativeArray<int> FirstOfChunk { get; }

        /// <summary>Statistics of all blocks that went through this slot.</summary>
        public NativeReference<PointStatistics> Statistics { get; }
        public NativeArray<AttributeStatistics> Attributes { get; }

        /// <summary>Times of this slot's jobs.</summary>
        public SliceTimes Slices { get; }

        /// <summary>Pages of the last block that are to be written.</summary>
        public NativeList<DetachedRecordPages> Detached { get; }

        /// <param name="result">Says how many points the batch has, when <paramref name="decoded"/> completes.</param>
        public JobHandle ScheduleGrouping(PointBatch batch, NativeReference<DecodeResult> result, in SourceGrid grid,
            JobHandle decoded)
        {
            return new GroupRecordsJob
            {
                Slices = Slices,
                Columns = batch.Bytes,
                Decoded = result,
                X = batch.Column(batch.Schema.IndexOf(AttributeNames.X)),
                Y = batch.Column(batch.Schema.IndexOf(AttributeNames.Y)),
                Z = batch.Column(batch.Schema.IndexOf(AttributeNames.Z)),
                Fields = m_fields,
                Grid = grid,
                Layout = m_layout,
                Chunks = m_map.Finder,
                ChunkOfCell = m_map.ChunkOfCell,
                Records = Records,
                FirstOfChunk = FirstOfChunk,
                ChunkOfPoint = m_chunkOfPoint,
                RunRecords = m_runRecords,
                Statistics = Statistics,
                Attributes = Attributes,
            }.Schedule(decoded);
        }

        /// <summary>Takes the statistics of the blocks since the last call.</summary>
        /// <param name="attributes">Statistics of each attribute, to which theirs are added.</param>
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
            m_runRecords.Dispose();
        }
    }
}
