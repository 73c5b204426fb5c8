using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    internal sealed class SummariseCloud : IBlockConsumer
    {
        struct SlotState
        {
            public NativeArray<PointColumn> Columns;
            public NativeArray<ColumnSummary> SummaryOfColumn;
            public NativeReference<PositionBounds> Bounds;
            public NativeArray<long> Counts;
        }

        const int ByteValues = SummariseBlockJob.ByteValues;

        readonly PointReader m_reader;
        readonly PointSchema m_schema;
        readonly bool m_hasPositions;
        readonly bool m_areRangesBounds;
        SlotState[] m_slots;

        public SummariseCloud(PointReader reader)
        {
            m_reader = reader;
            m_schema = reader.Info.Schema;
            m_hasPositions = m_schema.Has(AttributeNames.X) && m_schema.Has(AttributeNames.Y) && m_schema.Has(AttributeNames.Z);
            m_areRangesBounds = m_hasPositions && HaveWholeNumbers(m_schema, reader.Info.Transform);
            Summary = new CloudSummary { Columns = new ColumnSummary[m_schema.Count] };
            for (int i = 0; i < m_schema.Count; i++)
                Summary.Columns[i] = ColumnSummary.EmptyOf(m_schema[i].Type);
        }

        /// <summary>Called on the main thread with each block while its points are there; may be null.</summary>
        public Action<BlockRead> BlockCompleted { get; set; }

        public CloudSummary Summary { get; }

        /// <param name="slots">Blocks in flight; 0 for <see cref="SourceScan.SlotsFor"/>.</param>
        public IEnumerator<JobStep> Run(StageProgress progress, int slots = 0)
        {
            if (!m_reader.BlocksAreKnown)
            {
                progress?.Begin(PreviewSampling.FindBlocksStage);
                yield return JobStep.Of(m_reader.IndexBlocks());
            }
            progress?.Begin("scan");
            if (slots < 1)
                slots = SourceScan.SlotsFor(m_reader, m_schema);
            m_slots = new SlotState[slots];
            try
            {
                yield return JobStep.Of(SourceScan.Run(m_reader, m_schema, this, slots, progress));
                if (m_areRangesBounds && Summary.Points > 0)
                    TakeRanges();
                Summary.ClassCounts = TakeCounts(AttributeNames.Classification, 0);
                Summary.ReturnCounts = TakeCounts(AttributeNames.ReturnNumber, ByteValues);
            }
            finally
            {
                foreach (var state in m_slots)
                {
                    if (!state.Columns.IsCreated)
                        continue;
                    state.Columns.Dispose();
                    state.SummaryOfColumn.Dispose();
                    state.Bounds.Dispose();
                    state.Counts.Dispose();
                }
            }
            progress?.End();
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            if (!m_slots[slot].Columns.IsCreated)
                m_slots[slot] = NewState(read.Points);
            var state = m_slots[slot];
            return new SummariseBlockJob
            {
                Block = read.Points.Bytes,
                Columns = state.Columns,
                Result = read.Result,
                Transform = m_reader.Info.Transform,
                HasPositions = m_hasPositions && !m_areRangesBounds,
                Positions = m_hasPositions ? PositionColumns.Of(read.Points) : default,
                SummaryOfColumn = state.SummaryOfColumn,
                Bounds = state.Bounds,
                Counts = state.Counts,
                ClassColumn = IndexOfBytes(AttributeNames.Classification),
                ReturnColumn = IndexOfBytes(AttributeNames.ReturnNumber),
            }.Schedule(decoded);
        }

        /// <summary>Index of a column of bytes; -1 for none, or one of another type.</summary>
        int IndexOfBytes(string name)
        {
            int index = m_schema.IndexOf(name);
            return index >= 0 && m_schema[index].Type == AttributeType.UInt8 ? index : -1;
        }

        long[] TakeCounts(string name, int first)
        {
            if (IndexOfBytes(name) < 0)
                return null;
            var counts = new long[ByteValues];
            foreach (var state in m_slots)
                for (int i = 0; state.Counts.IsCreated && i < ByteValues; i++)
                    counts[i] += state.Counts[first + i];
            return counts;
        }

        public void Completed(BlockRead read, int slot)
        {
            var state = m_slots[slot];
            Summary.Points += read.Points.Count;
            BlockCompleted?.Invoke(read);
            for (int i = 0; i < m_schema.Count; i++)
                Summary.Columns[i].Include(state.SummaryOfColumn[i]);
            var found = state.Bounds.Value;
            var bounds = Summary.Bounds;
            bounds.Include(found.Bounds);
            Summary.Bounds = bounds;
            Summary.NonFiniteCount += found.NonFiniteCount;
        }

        static bool HaveWholeNumbers(PointSchema schema, in PositionTransform transform)
        {
            // Within these no 64-bit number becomes an infinity.
            bool isSafe = math.all(math.abs(transform.Scale) < 1e200) && math.all(math.abs(transform.Offset) < 1e200);
            foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                isSafe &= !schema[schema.IndexOf(axis)].Type.IsFloat();
            return isSafe;
        }

        void TakeRanges()
        {
            var x = Summary.Columns[m_schema.IndexOf(AttributeNames.X)];
            var y = Summary.Columns[m_schema.IndexOf(AttributeNames.Y)];
            var z = Summary.Columns[m_schema.IndexOf(AttributeNames.Z)];
            var bounds = BoundsGeo.Empty;
            bounds.Include(m_reader.Info.Transform.ToGeo(new double3(x.Min, y.Min, z.Min)));
            bounds.Include(m_reader.Info.Transform.ToGeo(new double3(x.Max, y.Max, z.Max)));
            Summary.Bounds = bounds;
        }

        static SlotState NewState(PointBatch batch)
        {
            var state = new SlotState
            {
                Columns = new NativeArray<PointColumn>(batch.Schema.Count, Allocator.Persistent),
                SummaryOfColumn = new NativeArray<ColumnSummary>(batch.Schema.Count, Allocator.Persistent),
                Bounds = new NativeReference<PositionBounds>(Allocator.Persistent),
                Counts = new NativeArray<long>(2 * ByteValues, Allocator.Persistent),
            };
            for (int i = 0; i < state.Columns.Length; i++)
                state.Columns[i] = batch.Column(i);
            return state;
        }
    }

    internal sealed class CloudSummary
    {
        public long Points { get; internal set; }

        public BoundsGeo Bounds { get; internal set; } = BoundsGeo.Empty;

        public long NonFiniteCount { get; internal set; }
        public ColumnSummary[] Columns { get; internal set; }

        public long[] ClassCounts { get; internal set; } // Points by class and by return number; null if there are none.
        public long[] ReturnCounts { get; internal set; }
    }

    [BurstCompile]
    internal struct SummariseBlockJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeArray<PointColumn> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        public PositionTransform Transform;
        public bool HasPositions; // Otherwise bounds stay empty: the source has no X, Y or Z, or bounds come from its ranges.

        public PositionColumns Positions;
        public NativeArray<ColumnSummary> SummaryOfColumn;
        public NativeReference<PositionBounds> Bounds;

        public const int ByteValues = 256;
        public int ClassColumn; // Columns of bytes whose values are counted, -1 for none; counts are added.
        public int ReturnColumn;
        public NativeArray<long> Counts;

        public unsafe void Execute()
        {
            byte* bytes = (byte*)Block.GetUnsafeReadOnlyPtr();
            int count = Result.Value.Points;
            for (int column = 0; column < Columns.Length; column++)
            {
                var summary = ColumnSummary.EmptyOf(Columns[column].Type);
                summary.IncludeColumn(bytes + Columns[column].OffsetBytes, count);
                SummaryOfColumn[column] = summary;
            }
            long* counts = (long*)Counts.GetUnsafePtr();
            if (ClassColumn >= 0)
                Count(bytes + Columns[ClassColumn].OffsetBytes, count, counts);
            if (ReturnColumn >= 0)
                Count(bytes + Columns[ReturnColumn].OffsetBytes, count, counts + ByteValues);
            Bounds.Value = HasPositions ? PositionBounds.Measure(bytes, Positions, Transform, 0, count) : PositionBounds.Empty;
        }

        static unsafe void Count(byte* values, int count, long* counts)
        {
            for (int i = 0; i < count; i++)
                counts[values[i]]++;
        }
    }
}
