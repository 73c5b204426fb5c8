using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Takes every block of a source into the chunks of a partition: into memory, and into files when that is
    /// full. Owns the records in memory until they are handed over.</summary>
    internal sealed class ScatterPoints : IThrottledConsumer, IDisposable
    {
        readonly BuildContext m_build;
        readonly List<RecordSlot> m_slots = new List<RecordSlot>();
        NativeArray<RecordPages> m_chunks;
        NativeReference<long> m_pagesDetached;
        SourceToGrid m_grid;
        PointReader m_reader;
        JobHandle m_lastAppend;
        long m_bytesDone;

        public ScatterPoints(BuildContext build)
        {
            m_build = build;
            m_chunks = new NativeArray<RecordPages>(build.Map.Chunks.Length + 1, Allocator.Persistent);
            m_pagesDetached = new NativeReference<long>(Allocator.Persistent);
            Attributes = new AttributeStatistics[build.Attributes.Count];
            for (int a = 0; a < Attributes.Length; a++)
                Attributes[a] = AttributeStatistics.None;
        }

        public long PointsDone { get; private set; }

        /// <summary>Sum of all that <see cref="TakeStatistics"/> added.</summary>
        public PointStatistics Statistics { get; private set; } = PointStatistics.None;

        public AttributeStatistics[] Attributes { get; }

        /// <summary>Records by chunk of the partition, the last those outside. Elements may be taken over and emptied.</summary>
        public NativeArray<RecordPages> Chunks => m_chunks;

        /// <summary>False while the disk lags behind.</summary>
        public bool IsReady
        {
            get
            {
                var files = m_build.Files;
                if (files == null || files.PagesWaiting <= m_build.Plan.MaxWaitingPages)
                    return true;
                files.Poll(1);
                return files.PagesWaiting <= m_build.Plan.MaxWaitingPages;
            }
        }

        public void BeginSource(PointReader reader, in SourceToGrid grid)
        {
            m_grid = grid;
            m_reader = reader;
        }

        public JobHandle Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            while (m_slots.Count <= slot)
                m_slots.Add(new RecordSlot(m_reader.MaxPointsPerBlock, m_build.Attributes, m_build.RecordLayout, m_build.Map,
                    read.Points));
            var s = m_slots[slot];
            var grouped = s.ScheduleGrouping(read.Points, read.Result, m_grid, decoded);
            var files = m_build.Files;
            files?.Poll(0);
            m_lastAppend = new AppendRecordsJob
            {
                Records = s.Records,
                FirstOfChunk = s.FirstOfChunk,
                Chunks = m_chunks,
                Pool = m_build.Pool,
                WrittenPages = files == null ? default : files.RemoveWritten(),
                MaxPages = m_build.Plan.MaxPages,
                PagesDetached = m_pagesDetached,
                Detached = s.Detached,
                SliceTimes = s.Slices,
            }.Schedule(JobHandle.CombineDependencies(grouped, m_lastAppend));
            return m_lastAppend;
        }

        public void Completed(BlockRead read, int slot)
        {
            foreach (var detached in m_slots[slot].Detached.AsArray())
                m_build.Files.Append(detached.Chunk, detached.Pages);
            PointsDone += read.Points.Count;
            m_bytesDone += m_reader.BytesOfRange(read.Range);
            m_build.Progress?.Report(PointsDone / (double)Math.Max(1, m_build.Points), PointsDone, m_bytesDone);
        }

        public void RestoreStatistics(BuildJournal journal)
        {
            for (int a = 0; a < journal.Attributes.Length; a++)
                Attributes[a] = journal.Attributes[a];
            var all = Statistics;
            foreach (var found in journal.Statistics)
            {
                PointsDone += found.Count + found.LeftOut;
                all.Include(found);
            }
            Statistics = all;
        }

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

        public IEnumerator<JobStep> WriteAll()
        {
            var files = m_build.Files;
            for (int c = 0; c < m_chunks.Length; c++)
            {
                files.Append(c, m_chunks[c]);
                m_chunks[c] = default;
            }
            while (files.PagesWaiting > 0)
            {
                files.Poll(1);
                yield return default;
            }
            var written = files.RemoveWritten();
            RecordPagePool.Of(m_build.Pool).Return(ref written);
            m_pagesDetached.Value = 0;
        }

        /// <summary>Coroutine, after a source's scan: frees what the next source has no use for, a part a step.</summary>
        public IEnumerator<JobStep> EndSource()
        {
            m_build.Files?.AddSliceTimesTo(m_build.SliceTimes);
            for (; m_slots.Count > 0; m_slots.RemoveAt(m_slots.Count - 1))
            {
                var slot = m_slots[m_slots.Count - 1];
                m_build.SliceTimes.TakeFrom(slot.Slices);
                slot.Dispose();
                yield return default;
            }
        }

        public void Dispose()
        {
            m_lastAppend.Complete();
            foreach (var slot in m_slots)
                slot.Dispose();
            m_slots.Clear();
            if (!m_chunks.IsCreated)
                return;
            m_chunks.Dispose();
            m_pagesDetached.Dispose();
        }
    }

    /// <summary>Copies one batch's grouped records to their chunks. These jobs run one after another, in the order of the source:
    /// since they only copy, neither locks nor the order of completion matter. If the chunks hold more pages than allowed, the
    /// largest ones give theirs up.</summary>
    [BurstCompile]
    internal unsafe struct AppendRecordsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<int> FirstOfChunk;
        public NativeArray<RecordPages> Chunks;
        public NativeReference<RecordPagePool> Pool;

        public RecordPages WrittenPages;

        public long MaxPages;

        public NativeReference<long> PagesDetached;
        public NativeList<DetachedRecordPages> Detached; // Out: full pages to be written, each once.

        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            var chunks = (RecordPages*)Chunks.GetUnsafePtr();
            ref var pool = ref RecordPagePool.Of(Pool);
            long detached = PagesDetached.Value - WrittenPages.PageCount;
            pool.Return(ref WrittenPages);
            Detached.Clear();
            for (int c = 0; c < Chunks.Length; c++)
            {
                int first = FirstOfChunk[c], count = FirstOfChunk[c + 1] - first;
                if (count > 0)
                    pool.Append(ref chunks[c], records + (long)first * pool.StrideBytes, count);
            }
            if (pool.PagesInUse - detached > MaxPages)
                detached += Detach(chunks, pool.PagesInUse - detached - MaxPages / 4 * 3);
            PagesDetached.Value = detached;
            SliceTimes.End(begin);
        }

        long Detach(RecordPages* chunks, long wanted)
        {
            long done = 0;
            while (done < wanted)
            {
                int largest = 0;
                for (int c = 1; c < Chunks.Length; c++)
                    if (chunks[c].PageCount > chunks[largest].PageCount)
                        largest = c;
                var pages = chunks[largest].DetachFull();
                if (pages.PageCount == 0)
                    break;
                done += pages.PageCount;
                Detached.Add(new DetachedRecordPages { Chunk = largest, Pages = pages });
            }
            return done;
        }
    }
}
