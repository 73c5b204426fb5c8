using System;
using System.Collections.Generic;
using FastPoints.Core;
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
    public sealed class RangeSampler : IDisposable
    {
        const int SlotsForShortRanges = 16;
        const int ShortRange = 4096;

        readonly PointReader m_reader;
        readonly PointSchema m_schema;
        readonly IReadOnlyList<BlockRange> m_ranges;
        readonly int m_wanted;
        readonly long m_total;
        readonly int m_longest;

        /// <param name="reader">Its blocks must be known.</param>
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

        public static List<BlockRange> Whole(PointReader reader) => Beginnings(reader, 1);

        /// <summary>A share, 0 to 1, of each block from its beginning; at least one point.</summary>
        public static List<BlockRange> Beginnings(PointReader reader, double share)
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

        public IEnumerator<JobStep> Run(StageProgress progress)
        {
            Points = new PointBatch(m_schema, Math.Max(1, m_wanted), Allocator.Persistent);
            if (m_wanted == 0)
                yield break;
            int slots = m_longest <= ShortRange ? SlotsForShortRanges : SourceScan.SlotsFor(m_reader, m_schema);
            slots = Math.Min(slots, m_ranges.Count);
            var reads = new BlockRead[slots];
            var columnsOfSlot = new NativeArray<PointColumn>[slots];
            var appended = new JobHandle[slots];
            var columnsOfSample = SampleBuffer.ColumnsOf(Points);
            var filled = new NativeReference<int>(Allocator.Persistent);
            JobHandle last = default;
            try
            {
                for (int i = 0; i < slots; i++)
                {
                    reads[i] = m_reader.CreateRead(m_schema, m_longest, Allocator.Persistent);
                    columnsOfSlot[i] = SampleBuffer.ColumnsOf(reads[i].Points);
                }
                long first = 0;
                for (int i = 0; i < m_ranges.Count + slots; i++)
                {
                    int slot = i % slots;
                    if (i >= slots)
                    {
                        yield return appended[slot];
                        appended[slot].Complete();
                        reads[slot].Complete();
                        BytesRead += m_reader.BytesOfRange(reads[slot].Range);
                        progress?.Report((i - slots + 1) / (double)m_ranges.Count, 0, BytesRead);
                    }
                    if (i >= m_ranges.Count)
                        continue;
                    reads[slot].Begin(m_ranges[i]);
                    // One after the other, so that the points come in the order of the ranges.
                    last = appended[slot] = new AppendPicksJob
                    {
                        Range = reads[slot].Points.Bytes,
                        ColumnsOfRange = columnsOfSlot[slot],
                        Result = reads[slot].Result,
                        FirstPoint = first,
                        Total = m_total,
                        Wanted = m_wanted,
                        ColumnsOfSample = columnsOfSample,
                        Sample = Points.Bytes,
                        Filled = filled,
                    }.Schedule(JobHandle.CombineDependencies(reads[slot].Decoded, last));
                    first += m_ranges[i].Count;
                    JobHandle.ScheduleBatchedJobs();
                }
                Points.Count = filled.Value;
            }
            finally
            {
                last.Complete();
                for (int i = 0; i < slots; i++)
                {
                    reads[i]?.Dispose();
                    if (columnsOfSlot[i].IsCreated)
                        columnsOfSlot[i].Dispose();
                }
                columnsOfSample.Dispose();
                filled.Dispose();
            }
        }

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

    [BurstCompile]
    public struct AppendPicksJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Range;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfRange;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        public long FirstPoint;
        public long Total;
        public int Wanted;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        public NativeArray<byte> Sample;

        public NativeReference<int> Filled;

        public unsafe void Execute()
        {
            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            long end = FirstPoint + Result.Value.Points;
            int filled = Filled.Value;
            long choice = FirstChoiceFrom(FirstPoint);
            while (choice < Wanted)
            {
                int run = 0;
                for (; run < RunLength && choice < Wanted; choice++)
                {
                    long point = choice * Total / Wanted;
                    if (point >= end)
                        break;
                    from[run] = (int)(point - FirstPoint);
                    to[run++] = filled++;
                }
                if (run == 0)
                    break;
                for (int column = 0; column < ColumnsOfSample.Length; column++)
                    ColumnCopy.Scatter((byte*)Range.GetUnsafeReadOnlyPtr() + ColumnsOfRange[column].OffsetBytes,
                        (byte*)Sample.GetUnsafePtr() + ColumnsOfSample[column].OffsetBytes, ColumnsOfSample[column].Type.SizeOf(),
                        from, to, run);
            }
            Filled.Value = filled;
        }

        long FirstChoiceFrom(long point) => (point * Wanted + Total - 1) / Total;
    }
}
