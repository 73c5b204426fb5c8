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
    /// <summary>Takes every block of a source into the chunks of a partition: into memory, and on to files where that has no more
    /// room. Owns the records in memory until they are handed over.</summary>
    internal sealed class ScatterPoints : IThrottledConsumer, IDisposable
    {
        readonly PointSchema m_attributes;
        readonly RecordLayout m_layout;
        readonly PartitionMap m_map;
        readonly NativeReference<RecordPagePool> m_pool;
        readonly RecordFiles m_files;
        readonly MemoryPlan m_plan;
        readonly StageProgress m_progress;
        readonly SliceTimes m_slices;
        readonly long m_allPoints;
        readonly List<RecordSlot> m_slots = new List<RecordSlot>();
        NativeArray<RecordPages> m_chunks;
        NativeReference<long> m_pagesDetached;
        SourceGrid m_grid;
        PointReader m_reader;
        JobHandle m_lastAppend;
        long m_pointsDone;
        long m_bytesDone;

        /// <param name="pool">Of all pages; whoever owns it frees them.</param>
        /// <param name="files">By chunk: where its pages go; null where all stay in memory.</param>
        /// <param name="allPoints">Of all sources, to show how far it is.</param>
        /// <param name="slices">Takes in how long the jobs ran.</param>
        public ScatterPoints(PointSchema attributes, RecordLayout layout, PartitionMap map, NativeReference<RecordPagePool> pool,
            RecordFiles files, MemoryPlan plan, long allPoints, SliceTimes slices, StageProgress progress)
        {
            m_attributes = attributes;
            m_layout = layout;
            m_map = map;
            m_pool = pool;
            m_files = files;
            m_plan = plan;
            m_allPoints = allPoints;
            m_progress = progress;
            m_slices = slices;
            m_chunks = new NativeArray<RecordPages>(map.Chunks.Length + 1, Allocator.Persistent);
            m_pagesDetached = new NativeReference<long>(Allocator.Persistent);
            Attributes = new AttributeStatistics[attributes.Count];
            for (int a = 0; a < Attributes.Length; a++)
                Attributes[a] = AttributeStatistics.None;
        }

        /// <summary>Of all that <see cref="TakeStatistics"/> took.</summary>
        public PointStatistics Statistics { get; set; } = PointStatistics.None;

        /// <summary>By attribute, the same.</summary>
        public AttributeStatistics[] Attributes { get; }

        /// <summary>Records by chunk of the partition, the last those outside. Elements may be taken over and emptied.</summary>
        public NativeArray<RecordPages> Chunks => m_chunks;

        /// <summary>Whether the disk keeps up.</summary>
        public bool IsReady
        {
            get
            {
                if (m_files == null || m_files.PagesWaiting <= m_plan.MostWaitingPages)
                    return true;
                m_files.Poll(1);
                return m_files.PagesWaiting <= m_plan.MostWaitingPages;
            }
        }

        /// <summary>Before a source's scan.</summary>
        public void BeginSource(PointReader reader, in SourceGrid grid)
        {
            m_grid = grid;
            m_reader = reader;
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            while (m_slots.Count <= slot)
                m_slots.Add(new RecordSlot(m_reader.MaxPointsPerBlock, m_attributes, m_layout, m_map, read.Points));
            var s = m_slots[slot];
            var grouped = s.ScheduleGrouping(read, m_grid, decoded);
            m_files?.Poll(0);
            m_lastAppend = new AppendRecordsJob
            {
                Records = s.Records,
                FirstOfChunk = s.FirstOfChunk,
                Chunks = m_chunks,
                Pool = m_pool,
                Returned = m_files == null ? default : m_files.TakeWritten(),
                MostPages = m_plan.MostPages,
                PagesDetached = m_pagesDetached,
                Detached = s.Detached,
                Slices = s.Slices,
            }.Schedule(JobHandle.CombineDependencies(grouped, m_lastAppend));
            return m_lastAppend;
        }

        public void Completed(BlockRead read, int slot)
        {
            foreach (var detached in m_slots[slot].Detached.AsArray())
                m_files.Append(detached.Chunk, detached.Pages);
            m_pointsDone += read.Points.Count;
            m_bytesDone += m_reader.BytesOfRange(read.Range);
            m_progress?.Report(m_pointsDone / (double)Math.Max(1, m_allPoints), m_pointsDone, m_bytesDone);
        }

        /// <summary>Points that a build before this one has done.</summary>
        public void Skip(long points) => m_pointsDone += points;

        /// <summary>When a scan has ended: takes in what it showed.</summary>
        /// <returns>What is new.</returns>
        public PointStatistics TakeStatistics()
        {
            m_lastAppend.Complete();
            m_lastAppend = default;
            var found = PointStatistics.None;
            foreach (var slot in m_slots)
                found.Include(slot.TakeStatistics(Attributes));
            var all = Statistics;
            all.Include(found);
            Statistics = all;
            return found;
        }

        /// <summary>Work for a pump, when a scan has ended: everything in memory goes to the files.</summary>
        public IEnumerator<Work> WriteAll()
        {
            for (int c = 0; c < m_chunks.Length; c++)
            {
                m_files.Append(c, m_chunks[c]);
                m_chunks[c] = default;
            }
            while (m_files.PagesWaiting > 0)
            {
                m_files.Poll(1);
                yield return default;
            }
            var written = m_files.TakeWritten();
            RecordPagePool.Of(m_pool).Return(ref written);
            m_pagesDetached.Value = 0;
        }

        /// <summary>After a source's scan.</summary>
        public void EndSource()
        {
            foreach (var slot in m_slots)
            {
                m_slices.Take(slot.Slices);
                slot.Dispose();
            }
            m_slots.Clear();
        }

        public void Dispose()
        {
            m_lastAppend.Complete();
            EndSource();
            if (!m_chunks.IsCreated)
                return;
            m_chunks.Dispose();
            m_pagesDetached.Dispose();
        }
    }
}
