using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Some points of all sources, spread evenly over their records, with all attributes: they represent what is not
    /// built yet. Owns its records.</summary>
    internal sealed class PlaceholderSample : IDisposable
    {
        /// <summary>Consecutive records are neighbours in space: ranges of 128 left most of a tile bare that ranges of
        /// 16 cover.</summary>
        const int RangePoints = 16;

        const int RangesPerSlice = 2048;

        readonly BuildContext m_build;
        readonly NativeReference<RecordPagePool> m_pool;
        readonly SliceTimes m_slices = new SliceTimes(Allocator.Persistent);
        RecordPages m_pages;

        /// <summary>The readers' blocks are known. Points outside the partition's cube will be left out.</summary>
        public PlaceholderSample(BuildContext build)
        {
            m_build = build;
            m_pool = new NativeReference<RecordPagePool>(new RecordPagePool(build.RecordLayout.StrideBytes,
                2 * build.Plan.PlaceholderPoints / RecordPages.RecordsPerPage), Allocator.Persistent);
            StatisticsOfAttributes = new AttributeStatistics[build.Attributes.Count];
            for (int a = 0; a < StatisticsOfAttributes.Length; a++)
                StatisticsOfAttributes[a] = AttributeStatistics.None;
        }

        public bool IsRead { get; private set; }

        public PointStatistics Statistics { get; private set; } = PointStatistics.None;
        public AttributeStatistics[] StatisticsOfAttributes { get; }

        public IEnumerator<JobStep> Read()
        {
            for (int i = 0; i < m_build.Readers.Count; i++)
            {
                var reader = m_build.Readers[i];
                double share = reader.PointCount / (double)Math.Max(1, m_build.Points);
                var ranges = SampleRanges.Choose(reader, (long)(m_build.Plan.PlaceholderPoints * share) / RangePoints,
                    RangePoints);
                yield return JobStep.Of(Read(reader, m_build.Grid.Sources[i], ranges));
            }
            IsRead = true;
        }

        /// <summary>Schedules the sample's distribution over cubes.</summary>
        /// <param name="cubes">See <see cref="DistributeRecordsJob.Cubes"/>.</param>
        /// <param name="corner">The octree's corner.</param>
        /// <param name="parts">Receives copies of the records for each cube, which <see cref="Return"/> takes back.</param>
        public JobHandle Distribute(NativeArray<GridCube> cubes, Grid3 corner, NativeArray<RecordPages> parts)
        {
            var job = new DistributeRecordsJob
            {
                Pages = m_pages,
                Layout = m_build.RecordLayout,
                Cubes = cubes,
                Corner = corner,
                Chunks = parts,
                Pool = m_pool,
                SliceTimes = m_slices,
            };
            var all = default(JobHandle);
            for (; job.FirstPage < m_pages.PageCount; job.FirstPage += DistributeRecordsJob.PagesPerSlice)
                all = job.Schedule(all);
            return all;
        }

        public void Return(RecordPages part) => RecordPagePool.Of(m_pool).Return(ref part);

        public void Dispose()
        {
            if (!m_pool.IsCreated)
                return;
            RecordPagePool.Of(m_pool).FreeAll();
            m_pool.Dispose();
            m_slices.Dispose();
        }

        IEnumerator<JobStep> Read(PointReader reader, SourceToGrid grid, List<BlockRange> ranges)
        {
            var wanted = reader.Info.Schema.SelectWithPosition(m_build.Attributes);
            if (reader is RecordReader records)
            {
                yield return JobStep.Of(ReadRanges(records, grid, ranges, wanted));
                yield break;
            }
            int longest = SourceSample.MaxPointsOf(ranges);
            var limit = SourceScan.LimitFor(reader, wanted, m_build.RecordLayout.StrideBytes + sizeof(int),
                m_build.Plan.ReadBytes / 4, m_build.Settings.Workers, m_build.InFlightMs);
            using var consumer = new Consumer(this, grid, longest);
            yield return JobStep.Of(SourceScan.Run(ScanRanges.Of(reader, ranges, longest), wanted, consumer, limit,
                m_build.Settings.Workers, null));
        }

        IEnumerator<JobStep> ReadRanges(RecordReader reader, SourceToGrid grid, List<BlockRange> ranges, PointSchema wanted)
        {
            var batch = new PointBatch(wanted, RangePoints * RangesPerSlice, Allocator.Persistent);
            var decoded = new NativeReference<DecodeResult>(Allocator.Persistent);
            var slot = new RecordSlot(batch.Capacity, m_build.Attributes, m_build.RecordLayout, m_build.Map, batch);
            try
            {
                for (int first = 0; first < ranges.Count; first += RangesPerSlice)
                {
                    int count = Math.Min(RangesPerSlice, ranges.Count - first), points = 0;
                    for (int r = first; r < first + count; r++)
                        points += ranges[r].Count;
                    yield return JobStep.Of(reader.ReadRanges(ranges, first, count, batch, read =>
                    {
                        decoded.Value = new DecodeResult { Points = points };
                        return slot.ScheduleGrouping(batch, decoded, grid, read);
                    }));
                    AddRecords(slot);
                }
            }
            finally
            {
                slot.Dispose();
                batch.Dispose();
                decoded.Dispose();
            }
        }

        /// <summary>Copies at once, since the records are few.</summary>
        unsafe void AddRecords(RecordSlot slot)
        {
            RecordPagePool.Of(m_pool).Append(ref m_pages,
                (byte*)Unity.Collections.LowLevel.Unsafe.NativeArrayUnsafeUtility.GetUnsafeReadOnlyPtr(slot.Records),
                slot.FirstOfChunk[m_build.Map.OutsideChunk]);
            var statistics = Statistics;
            statistics.Include(slot.TakeStatistics(StatisticsOfAttributes));
            Statistics = statistics;
        }

        sealed class Consumer : IBlockConsumer, IDisposable
        {
            readonly PlaceholderSample m_sample;
            readonly SourceToGrid m_grid;
            readonly int m_longest;
            readonly List<RecordSlot> m_slots = new List<RecordSlot>();

            public Consumer(PlaceholderSample sample, SourceToGrid grid, int longest)
            {
                m_sample = sample;
                m_grid = grid;
                m_longest = longest;
            }

            public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
            {
                var build = m_sample.m_build;
                if (slot == m_slots.Count)
                    m_slots.Add(new RecordSlot(m_longest, build.Attributes, build.RecordLayout, build.Map, read.Points));
                return m_slots[slot].ScheduleGrouping(read.Points, read.Result, m_grid, decoded);
            }

            public void Completed(BlockRead read, int slot) => m_sample.AddRecords(m_slots[slot]);

            public void Dispose()
            {
                foreach (var slot in m_slots)
                    slot.Dispose();
            }
        }
    }
}
