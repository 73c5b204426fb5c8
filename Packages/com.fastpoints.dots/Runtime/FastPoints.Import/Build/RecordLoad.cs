using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Reads records of temporary files back into pages, in the background.</summary>
    internal sealed unsafe class RecordLoad : IDisposable
    {
        readonly BuildContext m_build;
        readonly List<ReadHandle> m_reads = new List<ReadHandle>();
        readonly List<string> m_paths = new List<string>();

        // The read manager keeps the pointer to its commands until the read has ended.
        NativeArray<ReadCommand> m_commands;
        RecordPages m_pages;

        public RecordLoad(BuildContext build) => m_build = build;

        /// <summary>Completes when everything is read; then call <see cref="Complete"/>.</summary>
        public JobHandle Done { get; private set; }

        /// <summary>The pages, which have their records when <see cref="Done"/> completes.</summary>
        public RecordPages Pages => m_pages;

        /// <summary>Starts a load once the previous one is complete and the records are written.</summary>
        /// <param name="ranges">Ranges that together are one sequence of records.</param>
        /// <param name="first">First record of that sequence.</param>
        /// <param name="count">Number of records, at most as many as there are.</param>
        /// <param name="file">Null for the build's own files.</param>
        public void Begin(IReadOnlyList<RecordRange> ranges, long first, long count, string file = null)
        {
            ref var pool = ref RecordPagePool.Of(m_build.Pool);
            Reserve((int)(count / RecordPages.RecordsPerPage) + 1 + ranges.Count);
            var commands = (ReadCommand*)m_commands.GetUnsafePtr();
            int commandCount = 0;
            Done = default;
            foreach (var range in ranges)
            {
                long skipped = Math.Min(first, range.Count);
                first -= skipped;
                long left = Math.Min(count, range.Count - skipped), offset = (range.First + skipped) * pool.StrideBytes;
                if (left <= 0)
                    continue;
                count -= left;
                int firstCommand = commandCount;
                while (left > 0)
                {
                    var page = pool.Take();
                    page->Count = (int)Math.Min(left, RecordPages.RecordsPerPage);
                    long bytes = (long)page->Count * pool.StrideBytes;
                    commands[commandCount++] = new ReadCommand
                    {
                        Buffer = RecordPages.RecordsOf(page),
                        Offset = offset,
                        Size = bytes
                    };
                    m_pages.AddPage(page);
                    left -= page->Count;
                    offset += bytes;
                }
                string path = file ?? m_build.Files.PathOf(range.File);
                var read = FileReads.BeginOneShot(path, commands + firstCommand, commandCount - firstCommand);
                m_reads.Add(read);
                m_paths.Add(path);
                Done = JobHandle.CombineDependencies(Done, read.JobHandle);
            }
        }

        /// <summary>Ends the load; the caller owns the pages.</summary>
        /// <exception cref="PointCloudException">Not all of it could be read.</exception>
        public RecordPages Complete()
        {
            Done.Complete();
            PointCloudException failure = null;
            for (int i = 0; i < m_reads.Count; i++)
            {
                var status = m_reads[i].Status;
                m_reads[i].Dispose();
                if (status != ReadStatus.Complete && failure == null)
                    failure = new PointCloudException(FailureCode.ReadFailed, m_paths[i], -1, "the points that were set aside " +
                        "there cannot be read back: the read ended as " + status);
            }
            m_reads.Clear();
            m_paths.Clear();
            if (failure != null)
                throw failure;
            var pages = m_pages;
            m_pages = default;
            return pages;
        }

        public void Dispose()
        {
            foreach (var read in m_reads)
                read.Cancel();
            Done.Complete();
            foreach (var read in m_reads)
                read.Dispose();
            m_reads.Clear();
            if (m_commands.IsCreated)
                m_commands.Dispose();
        }

        void Reserve(int commands)
        {
            if (m_commands.IsCreated && m_commands.Length >= commands)
                return;
            if (m_commands.IsCreated)
                m_commands.Dispose();
            m_commands = new NativeArray<ReadCommand>(commands, Allocator.Persistent);
        }
    }

    /// <summary>Validates records from disk before use: those outside of their cube are
    /// counted, and put at its corner, so that dependent jobs that are already scheduled can run on them.</summary>
    [BurstCompile]
    internal unsafe struct CheckRecordsJob : IJob
    {
        const int PagesPerSlice = 64;

        public RecordPages Pages;
        public RecordLayout Layout;
        public GridCube Cube;

        public NativeReference<int> Outside;

        public SliceTimes Slices;

        /// <summary>Schedules the check of a list. All its pages are there already, and may get their records later.</summary>
        public static JobHandle Schedule(CheckRecordsJob job, JobHandle loaded)
        {
            for (var rest = job.Pages; rest.PageCount > 0; rest.PageCount -= PagesPerSlice)
            {
                job.Pages = rest;
                job.Pages.PageCount = System.Math.Min(PagesPerSlice, rest.PageCount);
                loaded = job.Schedule(loaded);
                for (int i = 0; i < job.Pages.PageCount; i++)
                    rest.First = rest.First->Next;
            }
            return loaded;
        }

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int outside = 0, stride = Layout.StrideBytes;
            var page = Pages.First;
            for (int p = 0; p < Pages.PageCount; p++, page = page->Next)
            {
                byte* record = RecordPages.RecordsOf(page);
                for (int i = 0; i < page->Count; i++, record += stride)
                {
                    if (Cube.Contains(Layout.PositionOf(record)))
                        continue;
                    Layout.SetPosition(record, Cube.Corner.X, Cube.Corner.Y, Cube.Corner.Z);
                    outside++;
                }
            }
            Outside.Value += outside;
            Slices.End(begin);
        }
    }
}
