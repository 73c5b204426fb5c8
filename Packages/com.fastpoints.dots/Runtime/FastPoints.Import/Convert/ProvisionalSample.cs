using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Partition;
using FastPoints.Points;
using FastPoints.Records;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Convert
{
    /// <summary>Some points of all sources, spread evenly over their records, with all attributes: they represent what is not
    /// built yet. Owns its records.</summary>
    internal sealed class ProvisionalSample : IDisposable
    {
        /// <summary>Records that lie together are neighbours in space: runs of 128 left most of a tile bare that runs of 16
        /// cover.</summary>
        const int RunPoints = 16;
        const int SlotsInFlight = 8;

        readonly BuildContext m_build;
        readonly NativeReference<RecordPagePool> m_pool;
        RecordPages m_pages;

        /// <summary>The readers' blocks are known. Points outside the partition's cube will be left out.</summary>
        public ProvisionalSample(BuildContext build)
        {
            m_build = build;
            m_pool = new NativeReference<RecordPagePool>(new RecordPagePool(build.Records.StrideBytes,
                2 * build.Plan.ProvisionalPoints / RecordPages.RecordsPerPage), Allocator.Persistent);
            Attributes = new AttributeStatistics[build.Attributes.Count];
            for (int a = 0; a < Attributes.Length; a++)
                Attributes[a] = AttributeStatistics.None;
        }

        public bool IsRead { get; private set; }

        /// <summary>Statistics of the points that were read.</summary>
        public PointStatistics Statistics { get; private set; } = PointStatistics.None;
        public AttributeStatistics[] Attributes { get; }

        /// <summary>Work for a pump: reads the sample.</summary>
        public IEnumerator<Work> Read()
        {
            for (int i = 0; i < m_build.Readers.Count; i++)
            {
                var reader = m_build.Readers[i];
                double share = reader.PointCount / (double)Math.Max(1, m_build.Points);
                var runs = SampleRuns.Choose(reader, (long)(m_build.Plan.ProvisionalPoints * share) / RunPoints, RunPoints);
                yield return Work.Of(Read(reader, m_build.Grid.Sources[i], runs));
            }
            IsRead = true;
        }

        /// <summary>Schedules the sample's distribution over cubes.</summary>
        /// <param name="cubes">See <see cref="RegroupCubesJob.Cubes"/>.</param>
        /// <param name="corner">The octree's corner.</param>
        /// <param name="parts">Receives copies of the records for each cube, which <see cref="Return"/> takes back.</param>
        public JobHandle Distribute(NativeArray<GridCube> cubes, Grid3 corner, NativeArray<RecordPages> parts) =>
            new RegroupCubesJob
            {
                Pages = m_pages,
                Layout = m_build.Records,
                Cubes = cubes,
                Corner = corner,
                Chunks = parts,
                Pool = m_pool,
            }.Schedule();

        /// <summary>Takes back a part.</summary>
        public void Return(RecordPages part) => RecordPagePool.Of(m_pool).Return(ref part);

        public void Dispose()
        {
            if (!m_pool.IsCreated)
                return;
            RecordPagePool.Of(m_pool).FreeAll();
            m_pool.Dispose();
        }

        IEnumerator<Work> Read(PointReader reader, SourceGrid grid, List<BlockRange> runs)
        {
            var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            foreach (var attribute in m_build.Attributes)
                names.Add(attribute.Name);
            var wanted = reader.Info.Schema.Select(names.ToArray());
            int longest = 1;
            foreach (var run in runs)
                longest = Math.Max(longest, run.Count);
            int slots = Math.Min(runs.Count, SlotsInFlight);
            var reads = new BlockRead[slots];
            var records = new RecordSlot[slots];
            var jobs = new JobHandle[slots];
            try
            {
                for (int s = 0; s < slots; s++)
                {
                    reads[s] = reader.CreateRead(wanted, longest, Allocator.Persistent);
                    records[s] = new RecordSlot(longest, m_build.Attributes, m_build.Records, m_build.Map, reads[s].Points);
                }
                for (int r = 0; r < runs.Count + slots; r++)
                {
                    int s = slots == 0 ? 0 : r % slots;
                    if (r >= slots && r - slots < runs.Count)
                    {
                        yield return jobs[s];
                        jobs[s].Complete();
                        reads[s].Complete();
                        Take(records[s]);
                    }
                    if (r >= runs.Count)
                        continue;
                    reads[s].Begin(runs[r]);
                    jobs[s] = records[s].ScheduleGrouping(reads[s], grid, reads[s].Decoded);
                    JobHandle.ScheduleBatchedJobs();
                }
            }
            finally
            {
                for (int s = 0; s < slots; s++)
                {
                    jobs[s].Complete();
                    reads[s]?.Dispose();
                    records[s]?.Dispose();
                }
            }
        }

        /// <summary>Copies a run here and now, since it has few records.</summary>
        unsafe void Take(RecordSlot slot)
        {
            m_pages.Append((byte*)Unity.Collections.LowLevel.Unsafe.NativeArrayUnsafeUtility.GetUnsafeReadOnlyPtr(slot.Records),
                slot.FirstOfChunk[m_build.Map.Outside], ref RecordPagePool.Of(m_pool));
            var statistics = Statistics;
            statistics.Include(slot.TakeStatistics(Attributes));
            Statistics = statistics;
        }
    }
}
