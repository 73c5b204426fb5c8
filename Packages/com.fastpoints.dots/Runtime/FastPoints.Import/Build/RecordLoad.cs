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
    internal sealed unsafe class RecordLoad : IDisposable
    {
        readonly BuildContext m_build;
        readonly SliceTimes m_slices;
        readonly List<ReadHandle> m_reads = new List<ReadHandle>();
        readonly List<string> m_paths = new List<string>();
        NativeReference<int> m_damaged = new NativeReference<int>(Allocator.Persistent);

        // The read manager keeps the pointer to its commands until the read has ended.
        NativeArray<ReadCommand> m_commands;
        NativeArray<UnpackRequest> m_parts;
        int m_commandCount;
        int m_partCount;
        RecordPages m_packed;
        RecordPages m_pages;

        /// <param name="slices">Of the jobs that follow a load, and of no others that run at the time.</param>
        public RecordLoad(BuildContext build, SliceTimes slices) => (m_build, m_slices) = (build, slices);

        public JobHandle Done { get; private set; }

        public RecordPages Pages => m_pages; // The pages, which have their records when Done completes.

        /// <summary>Starts a load once the previous one is complete and the records are written. No job may use the pool
        /// now.</summary>
        /// <param name="ranges">Ranges that together are one sequence of records.</param>
        /// <param name="first">First record of that sequence.</param>
        /// <param name="count">Number of records, at most as many as there are.</param>
        /// <param name="file">Null for the build's own files.</param>
        public void Begin(IReadOnlyList<RecordRange> ranges, long first, long count, RecordBlocks file = null)
        {
            Reserve(ranges, first, count, file);
            Done = default;
            m_damaged.Value = m_commandCount = m_partCount = 0;
            foreach (var range in ranges)
            {
                long skipped = Math.Min(first, range.Count);
                first -= skipped;
                long taken = Math.Min(count, range.Count - skipped);
                if (taken <= 0)
                    continue;
                count -= taken;
                BeginRange(file ?? m_build.Files.BlocksOf(range.File), range.First + skipped, taken);
            }
            var parts = m_parts.GetSubArray(0, m_partCount);
            for (int part = 0; part < m_partCount; part += UnpackRecordsJob.PartsPerRun)
                Done = new UnpackRecordsJob
                {
                    Requests = parts.GetSubArray(part, Math.Min(UnpackRecordsJob.PartsPerRun, m_partCount - part)),
                    StrideBytes = m_build.RecordLayout.StrideBytes,
                    Damaged = m_damaged,
                    SliceTimes = m_slices,
                }.Schedule(Done);
        }

        void BeginRange(RecordBlocks blocks, long first, long count)
        {
            ref var pool = ref RecordPagePool.Of(m_build.Pool);
            var commands = (ReadCommand*)m_commands.GetUnsafePtr();
            int firstCommand = m_commandCount, stride = pool.StrideBytes;
            // As many blocks as it has room for share a page until they are unpacked.
            long room = 0;
            RecordPages.Page* to = null;
            for (int block = blocks.Find(first); count > 0; block++)
            {
                int bytes = (int)(blocks.OffsetOf(block + 1) - blocks.OffsetOf(block));
                if (bytes > room)
                {
                    m_packed.AddPage(pool.Take());
                    room = RecordBlock.MaxBytes(stride);
                    commands[m_commandCount++] = new ReadCommand
                    {
                        Buffer = RecordBlock.Of(m_packed.Last),
                        Offset = blocks.OffsetOf(block),
                    };
                }
                ref var command = ref commands[m_commandCount - 1];
                var part = new UnpackRequest
                {
                    Block = (byte*)command.Buffer + command.Size,
                    BlockBytes = bytes,
                    BlockRecords = (int)(blocks.FirstOf(block + 1) - blocks.FirstOf(block)),
                    First = (int)(first - blocks.FirstOf(block)),
                };
                command.Size += bytes;
                room -= bytes;
                for (int left = (int)Math.Min(count, part.BlockRecords - part.First); left > 0; left -= part.Count)
                {
                    if (to == null || to->Count == RecordPages.RecordsPerPage)
                    {
                        to = pool.Take();
                        m_pages.AddPage(to);
                    }
                    part.Count = Math.Min(left, RecordPages.RecordsPerPage - to->Count);
                    part.Records = RecordPages.RecordsOf(to) + (long)to->Count * stride;
                    m_parts[m_partCount++] = part;
                    to->Count += part.Count;
                    m_pages.RecordCount += part.Count;
                    part.First += part.Count;
                    first += part.Count;
                    count -= part.Count;
                }
            }
            var read = FileReads.BeginOneShot(blocks.Path, commands + firstCommand, m_commandCount - firstCommand);
            m_reads.Add(read);
            m_paths.Add(blocks.Path);
            Done = JobHandle.CombineDependencies(Done, read.JobHandle);
        }

        /// <summary>Ends the load; the caller owns the pages. No job may use the pool now.</summary>
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
            if (failure == null && m_damaged.Value > 0)
                failure = Damaged(m_paths[0]);
            m_reads.Clear();
            m_paths.Clear();
            if (failure != null)
                throw failure;
            RecordPagePool.Of(m_build.Pool).Return(ref m_packed);
            var pages = m_pages;
            m_pages = default;
            return pages;
        }

        public static PointCloudException Damaged(string path) => new PointCloudException(FailureCode.ReadFailed, path, -1,
            "the points that were set aside there are damaged: delete the folder, and start again");

        public void Dispose()
        {
            foreach (var read in m_reads)
                read.Cancel();
            Done.Complete();
            foreach (var read in m_reads)
                read.Dispose();
            m_reads.Clear();
            m_damaged.Dispose();
            if (m_commands.IsCreated)
                m_commands.Dispose();
            if (m_parts.IsCreated)
                m_parts.Dispose();
        }

        void Reserve(IReadOnlyList<RecordRange> ranges, long first, long count, RecordBlocks file)
        {
            int commands = 0, parts = 0;
            foreach (var range in ranges)
            {
                long skipped = Math.Min(first, range.Count), taken = Math.Min(count, range.Count - skipped);
                first -= skipped;
                count -= Math.Max(0, taken);
                if (taken <= 0)
                    continue;
                var blocks = file ?? m_build.Files.BlocksOf(range.File);
                if (blocks.Records < range.First + skipped + taken)
                    throw Damaged(blocks.Path);
                int used = blocks.Find(range.First + skipped + taken - 1) - blocks.Find(range.First + skipped) + 1;
                commands += used;
                parts += used + (int)(taken / RecordPages.RecordsPerPage) + 1;
            }
            Reserve(ref m_commands, commands);
            Reserve(ref m_parts, parts);
        }

        static void Reserve<T>(ref NativeArray<T> array, int length) where T : struct
        {
            if (array.IsCreated && array.Length >= length)
                return;
            if (array.IsCreated)
                array.Dispose();
            array = new NativeArray<T>(length, Allocator.Persistent);
        }
    }

    [BurstCompile]
    internal unsafe struct UnpackRecordsJob : IJob
    {
        public const int PartsPerRun = 32; // A part is a page at most: this many take about a millisecond.

        [ReadOnly] public NativeArray<UnpackRequest> Requests;
        public int StrideBytes;
        public NativeReference<int> Damaged;
        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            foreach (var part in Requests)
                if (!RecordBlock.Unpack(part, StrideBytes))
                    Damaged.Value++;
            SliceTimes.End(begin);
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

        public SliceTimes SliceTimes;

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
            SliceTimes.End(begin);
        }
    }
}
