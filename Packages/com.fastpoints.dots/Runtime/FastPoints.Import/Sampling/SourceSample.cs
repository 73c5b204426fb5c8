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
    /// <summary>Stored positions of some points of one source, spread evenly over its records: enough to estimate the density,
    /// read in milliseconds. It is only an estimate: correctness never depends on it.</summary>
    internal sealed class SourceSample : IDisposable
    {
        // Eight times as many points gave the same chunks on tiles of 5 and 20 M points, and took 0.15 to 0.25 s
        // longer. In larger sources each range represents more points than a chunk has: there they are worth their
        // time.
        const int MaxRanges = 512;
        const int RangePoints = 256;
        const long LargeSourcePoints = 64 << 20;
        const int MaxRangesOfLarge = 1024;
        const int LongRangePoints = 1024;

        // Sources this small are read whole, in long ranges: the grid is chosen from all their digits.
        const int SmallSourcePoints = 16 << 10;

        const int PointsPerSlice = 1 << 16;

        NativeList<double3> m_stored;
        NativeList<SampleRange> m_ranges;

        SourceSample()
        {
            m_stored = new NativeList<double3>(Allocator.Persistent);
            m_ranges = new NativeList<SampleRange>(MaxRanges, Allocator.Persistent);
        }

        /// <summary>Positions as the file stores them, including those that are not finite.</summary>
        public NativeArray<double3> Stored => m_stored.AsArray();

        /// <summary>Ranges in the file's order: each stands for the points up to the next one.</summary>
        public NativeArray<SampleRange> Ranges => m_ranges.AsArray();

        /// <summary>Coroutine: reads the sample. The reader's blocks are known.</summary>
        /// <param name="inFlightMs">See <see cref="InFlightLimit"/>.</param>
        /// <param name="chains">The most ranges decoded at the same time; 0 for all in flight.</param>
        /// <param name="maxBytes">The most bytes of reads in flight.</param>
        /// <param name="measure">Schedules jobs on the positions, after those that load them.</param>
        /// <param name="take">Receives the sample at the end; the caller disposes it.</param>
        public static IEnumerator<JobStep> Read(PointReader reader, Func<double> inFlightMs, int chains, long maxBytes,
            Func<NativeArray<double3>, JobHandle, JobHandle> measure, Action<SourceSample> take)
        {
            var sample = new SourceSample();
            bool isLarge = reader.PointCount > LargeSourcePoints;
            var ranges = SampleRanges.Choose(reader, isLarge ? MaxRangesOfLarge : MaxRanges,
                isLarge || reader.PointCount <= SmallSourcePoints ? LongRangePoints : RangePoints);
            var positions = reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
            var measured = default(JobHandle);
            try
            {
                if (reader is RecordReader records)
                {
                    yield return JobStep.Of(sample.ReadRanges(records, ranges, positions, measure));
                }
                else
                {
                    int longest = MaxPointsOf(ranges);
                    var limit = SourceScan.LimitFor(reader, positions, 0, maxBytes, chains, inFlightMs);
                    using var consumer = new Appender(sample, reader, ranges, longest);
                    yield return JobStep.Of(SourceScan.Run(ScanRanges.Of(reader, ranges, longest), positions, consumer, limit,
                        chains, null));
                    measured = measure(sample.Stored, default);
                    yield return measured;
                    measured.Complete();
                    if (reader.Unfiltered is TiledReader tiles && tiles.TileCount > ranges.Count)
                        TileClaims.Add(tiles, ranges, sample.m_stored, sample.m_ranges);
                }
                take(sample);
                sample = null;
            }
            finally
            {
                measured.Complete();
                sample?.Dispose();
            }
        }

        /// <summary>Points of the longest range, at least 1.</summary>
        internal static int MaxPointsOf(List<BlockRange> ranges)
        {
            int longest = 1;
            foreach (var range in ranges)
                longest = Math.Max(longest, range.Count);
            return longest;
        }

        IEnumerator<JobStep> ReadRanges(RecordReader reader, List<BlockRange> ranges, PointSchema positions,
            Func<NativeArray<double3>, JobHandle, JobHandle> measure)
        {
            int points = 0;
            foreach (var range in ranges)
                points += range.Count;
            using var batch = new PointBatch(positions, Math.Max(1, points), Allocator.Persistent);
            using var decoded = new NativeReference<DecodeResult>(new DecodeResult { Points = points }, Allocator.Persistent);
            m_stored.ResizeUninitialized(points);
            var stored = Stored;
            yield return JobStep.Of(reader.ReadRanges(ranges, 0, ranges.Count, batch, read =>
            {
                for (int first = 0; first < points; first += PointsPerSlice)
                    read = Load(batch, decoded, first,
                        stored.GetSubArray(first, Math.Min(PointsPerSlice, points - first)), read);
                return measure(stored, read);
            }));
            for (int r = 0, first = 0; r < ranges.Count; first += ranges[r++].Count)
                AddRange(first, ranges[r].Count, PointsUpToNext(reader, ranges, r));
        }

        static JobHandle Load(PointBatch batch, NativeReference<DecodeResult> decoded, int first, NativeArray<double3> stored,
            JobHandle after) => new LoadSamplePositionsJob
            {
                Columns = batch.Bytes,
                Decoded = decoded,
                Positions = PositionColumns.Of(batch),
                First = first,
                Stored = stored,
            }.Schedule(after);

        /// <summary>Number of points from a range's first point to the next range's; the first range also represents
        /// those before it.</summary>
        static long PointsUpToNext(PointReader reader, List<BlockRange> ranges, int range)
        {
            long first = range == 0 ? 0 : reader.FirstPointOfBlock(ranges[range].Block) + ranges[range].First;
            return (range + 1 == ranges.Count ? reader.PointCount
                : reader.FirstPointOfBlock(ranges[range + 1].Block) + ranges[range + 1].First) - first;
        }

        void AddRange(int first, int count, long pointsRepresented) => m_ranges.Add(new SampleRange
        {
            First = first,
            Count = count,
            Weight = pointsRepresented / (double)Math.Max(1, count),
        });

        public void Dispose()
        {
            if (!m_stored.IsCreated)
                return;
            m_stored.Dispose();
            m_ranges.Dispose();
        }

        sealed class Appender : IBlockConsumer, IDisposable
        {
            readonly SourceSample m_sample;
            readonly PointReader m_reader;
            readonly List<BlockRange> m_ranges;
            readonly int m_longest;
            readonly List<NativeArray<double3>> m_buffers = new List<NativeArray<double3>>();

            public Appender(SourceSample sample, PointReader reader, List<BlockRange> ranges, int longest)
            {
                m_sample = sample;
                m_reader = reader;
                m_ranges = ranges;
                m_longest = longest;
            }

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
            {
                if (slot == m_buffers.Count)
                    m_buffers.Add(new NativeArray<double3>(m_longest, Allocator.Persistent,
                        NativeArrayOptions.UninitializedMemory));
                return Load(read.Points, read.Result, 0, m_buffers[slot], decoded);
            }

            public void Completed(BlockRead read, int slot)
            {
                int count = read.Points.Count;
                m_sample.AddRange(m_sample.m_stored.Length, count, PointsUpToNext(m_reader, m_ranges, m_sample.m_ranges.Length));
                m_sample.m_stored.AddRange(m_buffers[slot].GetSubArray(0, count));
            }

            public void Dispose()
            {
                foreach (var buffer in m_buffers)
                    buffer.Dispose();
            }
        }
    }

    /// <summary>Points of a sample that lie together in the file.</summary>
    internal struct SampleRange
    {
        public int First;

        public int Count;
        public double Weight; // Number of points of the file that each represents.
    }

    /// <summary>Loads stored positions of a few points as doubles: exact for 32-bit integers and floats.</summary>
    [BurstCompile]
    unsafe struct LoadSamplePositionsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        public PositionColumns Positions;

        public int First;
        public NativeArray<double3> Stored;

        public void Execute()
        {
            var bytes = (byte*)Columns.GetUnsafeReadOnlyPtr();
            int count = math.min(Decoded.Value.Points - First, Stored.Length);
            for (int i = 0; i < count; i++)
                Stored[i] = Positions.StoredAt(bytes, First + i);
        }
    }

    /// <summary>Where the points of many tiles are by their headers: of a country's tiles a sample sees few.</summary>
    internal static class TileClaims
    {
        const int MaxPoints = 1 << 21; // 48 MB of positions, for all tiles together.

        const int MaxPointsOfTile = 64;

        // Steps of an additive recurrence that fills a box evenly (Roberts, "The unreasonable effectiveness of quasirandom
        // sequences", 2018).
        static readonly double3 s_steps = new double3(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);

        /// <summary>Gives each sampled range the points of its own tile alone, and adds a range for each tile without one:
        /// positions spread over the tile's bounds.</summary>
        /// <param name="sampled">What was sampled, ascending.</param>
        /// <param name="stored">Positions as the file stores them.</param>
        /// <param name="ranges">One for each that was sampled.</param>
        public static void Add(TiledReader tiles, List<BlockRange> sampled, NativeList<double3> stored,
            NativeList<SampleRange> ranges)
        {
            int perTile = math.clamp(MaxPoints / tiles.TileCount, 1, MaxPointsOfTile);
            using var known = new NativeArray<SampleRange>(ranges.AsArray(), Allocator.Persistent);
            ranges.Clear();
            int next = 0;
            // Of tiles whose headers say nothing.
            long carried = 0;
            for (int t = 0; t < tiles.TileCount; t++)
            {
                long points = tiles.TileEntryOf(t).Points;
                var (first, count) = tiles.BlocksOf(t);
                int end = next;
                while (end < sampled.Count && sampled[end].Block < first + count)
                    end++;
                if (end > next)
                {
                    double ofRange = (points + carried) / (double)(end - next);
                    carried = 0;
                    for (; next < end; next++)
                        ranges.Add(Of(known[next].First, known[next].Count, ofRange));
                }
                else if (points > 0 && !tiles.BoundsOf(t).IsEmpty)
                {
                    ranges.Add(Of(stored.Length, perTile, points));
                    AddPositions(tiles.BoundsOf(t), tiles.Info.Transform, perTile, stored);
                }
                else
                {
                    carried += points;
                }
            }
        }

        static SampleRange Of(int first, int count, double points) =>
            new SampleRange { First = first, Count = count, Weight = points / Math.Max(1, count) };

        static void AddPositions(BoundsGeo bounds, PositionTransform transform, int count, NativeList<double3> stored)
        {
            // The sequence goes on from tile to tile: where each has one position, these are not all at the same height.
            int before = stored.Length;
            for (int i = before; i < before + count; i++)
            {
                var at = (i + 0.5) * s_steps;
                var geo = bounds.Min + bounds.Size * (at - math.floor(at));
                stored.Add(math.round((geo - transform.Offset) / transform.Scale));
            }
        }
    }
}
