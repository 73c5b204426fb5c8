using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>A sample while it is being collected: an entry for each wanted point, and which entries are filled.</summary>
    sealed class SampleBuffer : IDisposable
    {
        public const int EntriesPerSlice = 1 << 17; // Entries in one slice of such work: about 2 ms of managed code.
        public const int PointsPerSlice = 1 << 16; // Points in one slice that looks each up in a table: about the same time.

        readonly PositionTransform m_transform;
        NativeArray<byte> m_filled;
        NativeArray<PointColumn> m_columns;
        NativeReference<CompactedSample> m_state;
        bool m_isShared;

        public SampleBuffer(PointSchema schema, PositionTransform transform, int entryCount)
        {
            m_transform = transform;
            Points = new PointBatch(schema, Math.Max(1, entryCount), Allocator.Persistent);
            EntryCount = entryCount;
            m_filled = new NativeArray<byte>(Math.Max(1, entryCount), Allocator.Persistent);
            m_columns = ColumnsOf(Points);
            m_state = new NativeReference<CompactedSample>(new CompactedSample { Bounds = PositionBounds.Empty },
                Allocator.Persistent);
        }

        public PointBatch Points { get; }
        public int EntryCount { get; }
        public NativeArray<byte> Filled => m_filled;
        public NativeArray<PointColumn> Columns => m_columns;

        /// <summary>Entries that are closed, whether their point was kept or not. Only while nothing is in flight.</summary>
        public int ExaminedCount => m_state.Value.Kept + (int)m_state.Value.Bounds.NonFiniteCount;

        public unsafe void MarkAllFilled() => UnsafeUtility.MemSet(m_filled.GetUnsafePtr(), 1, m_filled.Length);

        /// <summary>The location of the batch's columns, for a job. The caller disposes it.</summary>
        public static NativeArray<PointColumn> ColumnsOf(PointBatch batch)
        {
            var columns = new NativeArray<PointColumn>(batch.Schema.Count, Allocator.Persistent);
            for (int i = 0; i < columns.Length; i++)
                columns[i] = batch.Column(i);
            return columns;
        }

        /// <summary>Schedules the choice of a range's points that stand for their strata, in slices.</summary>
        /// <param name="columns">The columns of the read's points.</param>
        public JobHandle Schedule(BlockRead read, NativeArray<PointColumn> columns, SampleStrata strata, JobHandle decoded)
        {
            for (int first = 0; first < read.Range.Count; first += EntriesPerSlice)
                decoded = new SampleBlockJob
                {
                    Block = read.Points.Bytes,
                    ColumnsOfBlock = columns,
                    Result = read.Result,
                    First = first,
                    End = Math.Min(read.Range.Count, first + EntriesPerSlice),
                    RangeFirstPoint = read.FirstPoint,
                    Strata = strata,
                    ColumnsOfSample = m_columns,
                    Sample = Points.Bytes,
                    Filled = m_filled,
                }.Schedule(decoded);
            return decoded;
        }

        /// <summary>Coroutine: closes the gaps between the filled entries from <paramref name="begin"/> to before
        /// <paramref name="end"/>, after those that are closed already.</summary>
        /// <param name="after">What its jobs depend on; it is complete in the end.</param>
        public IEnumerator<JobStep> Compact(int begin, int end, JobHandle after = default) => Append(this, begin, end, after);

        /// <summary>Coroutine: appends the filled entries of another buffer, or of this one, to what is closed.</summary>
        public IEnumerator<JobStep> Append(SampleBuffer from, int begin, int end, JobHandle after = default)
        {
            yield return JobStep.Of(Slices.Run(begin, end, EntriesPerSlice, (first, stop, before) => new CompactSampleJob
            {
                Filled = from.m_filled,
                Columns = from.m_columns,
                Sample = from.Points.Bytes,
                Positions = PositionColumns.Of(from.Points),
                Transform = m_transform,
                First = first,
                Count = stop - first,
                ColumnsOfTarget = m_columns,
                Target = Points.Bytes,
                State = m_state,
            }.Schedule(before), 1, after));
            Points.Count = m_state.Value.Kept;
        }

        /// <summary>Of what is compacted so far, for <see cref="UpdateSample"/>; it owns the points from now on.</summary>
        public PreviewSample CreateSample()
        {
            m_isShared = true;
            var sample = new PreviewSample(Points, m_transform);
            UpdateSample(sample);
            return sample;
        }

        /// <summary>Updates a sample of these points after more were closed.</summary>
        public void UpdateSample(PreviewSample sample)
        {
            var state = m_state.Value;
            sample.Bounds = state.Bounds.Bounds;
            sample.NonFiniteCount = state.Bounds.NonFiniteCount;
        }

        public void Dispose()
        {
            if (!m_isShared)
                Points.Dispose();
            if (!m_filled.IsCreated)
                return;
            m_filled.Dispose();
            m_columns.Dispose();
            m_state.Dispose();
        }
    }

    internal static class SampleSchema
    {
        /// <exception cref="PointCloudException">The source has no positions.</exception>
        public static PointSchema Of(SourceInfo info)
        {
            var names = new List<string>(info.ExtraSampledAttributes)
            {
                AttributeNames.X, AttributeNames.Y, AttributeNames.Z, AttributeNames.Intensity, AttributeNames.Classification,
                AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue,
            };
            var schema = info.Schema.Select(names.ToArray());
            if (!schema.Has(AttributeNames.X) || !schema.Has(AttributeNames.Y) || !schema.Has(AttributeNames.Z))
                throw new PointCloudException(FailureCode.Unsupported, info.Path, -1,
                    "nothing to draw: wanted attributes X, Y and Z, got " + info.Schema);
            return schema;
        }
    }

    struct CompactedSample
    {
        public int Kept; // Points kept so far: the first entries of each column.

        public PositionBounds Bounds;
    }

    /// <summary>Closes the gaps in a sample, one slice of entries after the other: entries without a point, and points whose
    /// position is not finite, which are counted. It measures the bounds on the way.</summary>
    [BurstCompile]
    struct CompactSampleJob : IJob
    {
        const int BatchLength = ColumnValues.BatchLength;

        [ReadOnly] public NativeArray<byte> Filled;
        [ReadOnly] public NativeArray<PointColumn> Columns;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Sample;
        public PositionColumns Positions;
        public PositionTransform Transform;
        public int First;
        public int Count;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Target; // May be the sample itself.
        [ReadOnly, NativeDisableContainerSafetyRestriction] public NativeArray<PointColumn> ColumnsOfTarget;
        public NativeReference<CompactedSample> State;

        public unsafe void Execute()
        {
            double* x = stackalloc double[BatchLength];
            double* y = stackalloc double[BatchLength];
            double* z = stackalloc double[BatchLength];
            int* fromIndex = stackalloc int[BatchLength];
            int* toIndex = stackalloc int[BatchLength];
            var copy = new ColumnCopy
            {
                From = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Sample),
                To = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Target),
                ColumnsOfSource = Columns,
                ColumnsOfTarget = ColumnsOfTarget,
            };
            var state = State.Value;
            for (int done = 0; done < Count; done += BatchLength)
            {
                int start = First + done;
                int length = math.min(BatchLength, Count - done);
                Positions.Load(copy.From, start, length, x, y, z);
                Transform.ToGeo(length, x, y, z);
                int kept = 0;
                for (int i = 0; i < length; i++)
                {
                    if (Filled[start + i] == 0)
                        continue;
                    if (!PositionBounds.IsFinite(x[i], y[i], z[i]))
                    {
                        state.Bounds.NonFiniteCount++;
                        continue;
                    }
                    x[kept] = x[i];
                    y[kept] = y[i];
                    z[kept] = z[i];
                    fromIndex[kept] = start + i;
                    toIndex[kept] = state.Kept + kept;
                    kept++;
                }
                state.Bounds.IncludeBatch(x, y, z, kept);
                if (copy.From != copy.To || state.Kept != start || kept != length)
                    copy.Scatter(fromIndex, toIndex, kept);
                state.Kept += kept;
            }
            State.Value = state;
        }
    }

    /// <summary>Copies the chosen points of a decoded block to the sample: stratum i's point to entry i. Blocks write to disjoint
    /// entries, so any number of these may run at the same time.</summary>
    [BurstCompile]
    struct SampleBlockJob : IJob
    {
        const int BatchLength = ColumnValues.BatchLength;

        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfBlock;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        public int First;
        public int End;

        public long RangeFirstPoint;

        public SampleStrata Strata;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Sample;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Filled; // Set to 1 at each entry that is written.

        public unsafe void Execute()
        {
            long begin = RangeFirstPoint + First;
            long end = math.min(RangeFirstPoint + math.min(End, Result.Value.Points), Strata.Points);
            if (end <= begin)
                return;
            int* fromIndex = stackalloc int[BatchLength];
            int* toIndex = stackalloc int[BatchLength];
            var copy = new ColumnCopy
            {
                From = (byte*)Block.GetUnsafeReadOnlyPtr(),
                To = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Sample),
                ColumnsOfSource = ColumnsOfBlock,
                ColumnsOfTarget = ColumnsOfSample,
            };
            byte* filled = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Filled);
            int chosen = 0;
            int last = Strata.StratumOf(end - 1);
            for (int stratum = Strata.StratumOf(begin); stratum <= last; stratum++)
            {
                long point = Strata.Chosen(stratum);
                if (point >= begin && point < end)
                {
                    fromIndex[chosen] = (int)(point - RangeFirstPoint);
                    toIndex[chosen] = stratum;
                    chosen++;
                }
                if (chosen < BatchLength && stratum < last)
                    continue;
                copy.Scatter(fromIndex, toIndex, chosen);
                for (int i = 0; i < chosen; i++)
                    filled[toIndex[i]] = 1;
                chosen = 0;
            }
        }
    }
}
