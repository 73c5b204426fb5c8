using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Evaluation
{
    /// <summary>A sample as one would take it without much thought: regular choices from given ranges of a source, in the order
    /// of the ranges. Every n-th point of all, the first N, the prefixes of all chunks: what better samplers are compared
    /// with.</summary>
    public sealed class RangeSampler : IBlockConsumer, IDisposable
    {
        const int SlotsForShortRanges = 16;

        const int ShortRange = 4096;

        readonly PointReader m_reader;
        readonly PointSchema m_schema;
        readonly IReadOnlyList<BlockRange> m_ranges;
        readonly int m_wanted;
        readonly long m_total;
        readonly int m_longest;
        readonly List<NativeArray<PointColumn>> m_columnsOfSlot = new List<NativeArray<PointColumn>>();
        NativeArray<PointColumn> m_columns;
        NativeReference<int> m_filled;
        JobHandle m_last;
        long m_begun; // Points of the ranges that were begun.

        /// <param name="reader">Its blocks must be known.</param>
        /// <param name="wanted">Points; no more than the ranges hold and than <see cref="PreviewSample.MaxPoints"/> are
        /// taken.</param>
        public RangeSampler(PointReader reader, IReadOnlyList<BlockRange> ranges, int wanted)
        {
            m_reader = reader;
            m_schema = SampleSchema.Of(reader.Info);
            m_ranges = ranges;
            foreach (var range in ranges)
            {
                m_total += range.Count;
                m_longest = Math.Max(m_longest, range.Count);
            }
            m_wanted = (int)Math.Max(0, Math.Min(Math.Min(wanted, m_total), PreviewSample.MaxPoints(m_schema)));
        }

        /// <summary>The points, as the source stores them, positions that are not finite among them. Owned by this; null before
        /// <see cref="Run"/>.</summary>
        public PointBatch Points { get; private set; }

        public long BytesRead { get; private set; }

        /// <summary>All points of a source, block by block.</summary>
        public static List<BlockRange> Whole(PointReader reader) => Prefixes(reader, 1);

        /// <summary>A share, 0 to 1, of each block from its beginning; at least one point.</summary>
        public static List<BlockRange> Prefixes(PointReader reader, double share)
        {
            var ranges = new List<BlockRange>(reader.BlockCount);
            for (int block = 0; block < reader.BlockCount; block++)
            {
                int points = reader.PointsInBlock(block);
                if (points > 0)
                    ranges.Add(new BlockRange(block, 0, (int)Math.Min(points, Math.Max(1, Math.Ceiling(points * share)))));
            }
            return ranges;
        }

        /// <summary>The first points of a source.</summary>
        public static List<BlockRange> First(PointReader reader, long points)
        {
            var ranges = new List<BlockRange>();
            for (int block = 0; block < reader.BlockCount && points > 0; block++)
            {
                int count = (int)Math.Min(points, reader.PointsInBlock(block));
                if (count > 0)
                    ranges.Add(new BlockRange(block, 0, count));
                points -= count;
            }
            return ranges;
        }

        /// <summary>Every n-th point of a source on its own, n = all / points: for sources of a fixed stride.</summary>
        public static List<BlockRange> Single(PointReader reader, int points)
        {
            var ranges = new List<BlockRange>(points);
            int block = 0;
            for (int i = 0; i < points; i++)
            {
                long point = (long)i * reader.PointCount / points;
                while (point >= reader.FirstPointOfBlock(block) + reader.PointsInBlock(block))
                    block++;
                ranges.Add(new BlockRange(block, (int)(point - reader.FirstPointOfBlock(block)), 1));
            }
            return ranges;
        }

        /// <summary>Coroutine, once.</summary>
        public IEnumerator<JobStep> Run(StageProgress progress)
        {
            Points = new PointBatch(m_schema, Math.Max(1, m_wanted), Allocator.Persistent);
            if (m_wanted == 0)
                yield break;
            int slots = m_longest <= ShortRange ? SlotsForShortRanges : SourceScan.SlotsFor(m_reader, m_schema);
            m_columns = SampleBuffer.ColumnsOf(Points);
            m_filled = new NativeReference<int>(Allocator.Persistent);
            try
            {
                yield return JobStep.Of(SourceScan.Run(ScanRanges.Of(m_reader, m_ranges, m_longest), m_schema, this,
                    new InFlightLimit(slots, slots, () => 0), 0, progress));
                Points.Count = m_filled.Value;
            }
            finally
            {
                m_last.Complete();
                foreach (var columns in m_columnsOfSlot)
                    columns.Dispose();
                m_columns.Dispose();
                m_filled.Dispose();
            }
        }

        /// <summary>One after the other, so that the points come in the order of the ranges.</summary>
        JobHandle IBlockConsumer.Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            if (slot == m_columnsOfSlot.Count)
                m_columnsOfSlot.Add(SampleBuffer.ColumnsOf(read.Points));
            m_last = new AppendPicksJob
            {
                Range = read.Points.Bytes,
                ColumnsOfRange = m_columnsOfSlot[slot],
                Result = read.Result,
                FirstPoint = m_begun,
                Total = m_total,
                Wanted = m_wanted,
                ColumnsOfSample = m_columns,
                Sample = Points.Bytes,
                Filled = m_filled,
            }.Schedule(JobHandle.CombineDependencies(decoded, m_last));
            m_begun += read.Range.Count;
            return m_last;
        }

        void IBlockConsumer.Completed(BlockRead read, int slot) => BytesRead += m_reader.BytesOfRange(read.Range);

        /// <summary>Hands the points over, once.</summary>
        public PointBatch TakePoints()
        {
            var points = Points;
            Points = null;
            return points;
        }

        public void Dispose()
        {
            Points?.Dispose();
            Points = null;
        }
    }

    /// <summary>Appends, of the points of a decoded range, those that a regular choice falls on: the k-th choice of
    /// <see cref="Wanted"/> is point floor(k * Total / Wanted).</summary>
    [BurstCompile]
    public struct AppendPicksJob : IJob
    {
        const int BatchLength = ColumnValues.BatchLength;

        [ReadOnly] public NativeArray<byte> Range;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfRange;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        /// <summary>Where the range begins among the <see cref="Total"/> points to choose from.</summary>
        public long FirstPoint;
        public long Total;

        /// <summary>No more than <see cref="Total"/>, and than the sample has places.</summary>
        public int Wanted;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        public NativeArray<byte> Sample;

        /// <summary>Entries filled so far.</summary>
        public NativeReference<int> Filled;

        public unsafe void Execute()
        {
            var copy = new ColumnCopy
            {
                From = (byte*)Range.GetUnsafeReadOnlyPtr(),
                To = (byte*)Sample.GetUnsafePtr(),
                ColumnsOfSource = ColumnsOfRange,
                ColumnsOfTarget = ColumnsOfSample,
            };
            int* from = stackalloc int[BatchLength];
            int* to = stackalloc int[BatchLength];
            long end = FirstPoint + Result.Value.Points;
            int filled = Filled.Value;
            long choice = FirstChoiceFrom(FirstPoint);
            while (choice < Wanted)
            {
                int length = 0;
                for (; length < BatchLength && choice < Wanted; choice++)
                {
                    long point = choice * Total / Wanted;
                    if (point >= end)
                        break;
                    from[length] = (int)(point - FirstPoint);
                    to[length++] = filled++;
                }
                if (length == 0)
                    break;
                copy.Scatter(from, to, length);
            }
            Filled.Value = filled;
        }

        /// <summary>The first choice at a point or behind it: ceil(point * Wanted / Total).</summary>
        long FirstChoiceFrom(long point) => (point * Wanted + Total - 1) / Total;
    }
}
