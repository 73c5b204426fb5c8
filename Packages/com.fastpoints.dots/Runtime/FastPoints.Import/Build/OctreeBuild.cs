using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Build
{
    internal sealed class OctreeBuild : IDisposable
    {
        sealed class Slot : IDisposable
        {
            public ChunkIndexer Indexer;
            public IndexWorkspace Workspace;
            public RecordLoad Load;

            public NativeReference<int> Outside;
            public int Chunk;

            public void Dispose()
            {
                Indexer.Dispose();
                Load?.Dispose();
                if (Outside.IsCreated)
                    Outside.Dispose();
                Outside = default;
            }
        }

        const double PointsPerMs = 8000; // Points of chunks that a worker takes in a millisecond at most.

        readonly BuildContext m_build;
        readonly ChunkSet m_chunks;
        readonly NativeStoreLayout m_store;
        readonly BuildGenerations m_generations;
        readonly Queue<Slot> m_inFlight = new Queue<Slot>();
        readonly Stack<Slot> m_idle = new Stack<Slot>();
        readonly List<IndexWorkspace> m_workspaces = new List<IndexWorkspace>();
        readonly ChunkResult[] m_results;
        ChunkWrites m_writes;
        UpperMerge m_merge;
        InFlightLimit m_limit;
        JobHandle m_newest;
        long m_chunkBytes;
        long m_inFlightBytes;
        long m_points;
        long m_pointsDone;

        public OctreeBuild(BuildContext build, ChunkSet chunks, CloudManifest manifest, BuildGenerations generations)
        {
            m_build = build;
            m_chunks = chunks;
            m_generations = generations;
            Manifest = manifest;
            m_store = new NativeStoreLayout(manifest.CreateLayout());
            m_results = new ChunkResult[chunks.Chunks.Count];
            TopRecords = new NativeArray<byte>[m_results.Length];
            BytesOfPlane = new long[m_store.Layout.Planes.Count];
        }

        public CloudManifest Manifest { get; } // Complete when all work is done, except the display ranges.

        public ulong Checksum { get; private set; }
        public int LevelCount { get; private set; }
        public long[] BytesOfPlane { get; }

        public int MinSideLog2 { get; private set; }

        /// <summary>By chunk, when they are indexed; tops that are in files have no records here.</summary>
        public IReadOnlyList<ChunkResult> Results => m_results;
        public NativeArray<byte>[] TopRecords { get; }

        /// <summary>Coroutine: every chunk, several at once; then the upper levels and the hierarchy.</summary>
        public IEnumerator<JobStep> Run()
        {
            yield return JobStep.Of(Index());
            m_build.Progress?.Begin(BuildStages.Merge);
            m_merge = new UpperMerge(m_build, m_store, Manifest);
            yield return JobStep.Of(m_merge.Run(m_results, TopRecords, m_build.Progress));
            for (int p = 0; p < BytesOfPlane.Length; p++)
                BytesOfPlane[p] += m_merge.BytesOfPlane[p];
            int lowest = Math.Min(MinSideLog2, m_merge.MinSideLog2);
            LevelCount = m_results.Length == 0 ? 0 : Manifest.Root.SideLog2 - lowest + 1;
        }

        public IEnumerator<JobStep> Index()
        {
            m_build.Progress?.Begin(BuildStages.Index);
            yield return JobStep.Of(IndexChunks());
            yield return JobStep.Of(Free());
            MinSideLog2 = Manifest.Root.SideLog2;
            foreach (var result in m_results)
            {
                Checksum += result.Checksum;
                MinSideLog2 = Math.Min(MinSideLog2, result.MinSideLog2);
                for (int p = 0; p < BytesOfPlane.Length; p++)
                    BytesOfPlane[p] += result.BytesOfPlane[p];
            }
        }

        /// <summary>Frees what chunks needed, a part a step: large blocks take milliseconds.</summary>
        IEnumerator<JobStep> Free()
        {
            var freed = default(JobHandle);
            try
            {
                for (int slabs = RecordPagePool.Of(m_build.Pool).SlabCount; slabs > 0; slabs--)
                    freed = new FreeSlabJob { Pool = m_build.Pool }.Schedule(freed);
                // Other jobs would wait for the kernel beside them as long.
                yield return freed;
                for (; m_idle.Count > 0; m_idle.Pop().Dispose())
                    yield return default;
                foreach (var workspace in m_workspaces)
                {
                    workspace.Dispose();
                    yield return default;
                }
                m_writes.Dispose();
            }
            finally
            {
                freed.Complete();
            }
        }

        public void Dispose()
        {
            while (m_inFlight.Count > 0)
                m_idle.Push(m_inFlight.Dequeue());
            while (m_idle.Count > 0)
                m_idle.Pop().Dispose();
            foreach (var workspace in m_workspaces)
                workspace.Dispose();
            m_writes?.Dispose();
            m_merge?.Dispose();
            m_store.Dispose();
            foreach (var result in m_results)
                result?.Dispose();
            for (int i = 0; i < TopRecords.Length; i++)
            {
                if (TopRecords[i].IsCreated)
                    TopRecords[i].Dispose();
                TopRecords[i] = default;
            }
        }

        IEnumerator<JobStep> IndexChunks()
        {
            var watch = Stopwatch.StartNew();
            double mergeSeconds = 0;
            var order = new List<int>();
            yield return JobStep.Of(FindChunksLeft(order));
            CreateWorkspaces(order.Count);
            for (int next = 0; next < order.Count || m_inFlight.Count > 0;)
            {
                if (next < order.Count && m_inFlight.Count < m_limit.Value)
                {
                    Begin(order[next++]);
                    // Lets the coroutine check its budget.
                    yield return default;
                    continue;
                }
                m_limit.BeginWait();
                yield return m_inFlight.Peek().Indexer.Job;
                m_limit.EndWait(next < order.Count && m_newest.IsCompleted);
                yield return JobStep.Of(Finish(m_inFlight.Peek()));
                m_idle.Push(m_inFlight.Dequeue());
                if (m_inFlight.Count == 0 && next == order.Count || !IsGenerationDue(watch.Elapsed.TotalSeconds, mergeSeconds))
                    continue;
                double begin = watch.Elapsed.TotalSeconds;
                yield return JobStep.Of(WriteGeneration());
                mergeSeconds = watch.Elapsed.TotalSeconds - begin;
                watch.Restart();
            }
            while (!m_writes.IsDone)
            {
                m_writes.Poll(1);
                yield return default;
            }
        }

        /// <summary>Chunks that the resumed build has not finished, the largest first, so that no large one runs alone
        /// at the end.</summary>
        IEnumerator<JobStep> FindChunksLeft(List<int> order)
        {
            int stride = m_build.RecordLayout.ForTops(m_store.HasAverages).StrideBytes;
            for (int i = 0; i < m_results.Length; i++)
            {
                var (number, chunk) = (i, m_chunks.Chunks[i]);
                if (m_build.Files != null)
                    yield return JobStep.Of(PoolTask.Run(m_build.Folder.PathOf(BuildFiles.TopPath(i)),
                        () => ReadFinishedChunk(number, stride), result => m_results[number] = result));
                m_points += chunk.Count;
                if (m_results[i] == null)
                {
                    order.Add(i);
                    continue;
                }
                m_pointsDone += chunk.Count;
                foreach (var range in chunk.Ranges)
                    m_build.Files.Release(range.File);
            }
            order.Sort((a, b) =>
            {
                int bySize = m_chunks.Chunks[b].Count.CompareTo(m_chunks.Chunks[a].Count);
                return bySize != 0 ? bySize : a.CompareTo(b);
            });
        }

        /// <summary>As many as there are workers and memory for, and at least one; and as many chunks ahead as half of the rest
        /// has room for. The other half is for what shows the finished ones meanwhile.</summary>
        void CreateWorkspaces(int chunks)
        {
            var files = m_build.Files;
            var plan = m_build.Plan;
            int stride = m_build.RecordLayout.StrideBytes;
            long largest = 1;
            foreach (var chunk in m_chunks.Chunks)
                largest = Math.Max(largest, chunk.Count);
            m_chunkBytes = largest * (plan.IndexBytesPerPoint - (files == null ? stride : 0));
            // A chunk that is not in its workspace's memory has its file and its top, or its records where they come from a disk,
            // and another's file is being written.
            m_inFlightBytes = largest * stride * (files == null ? 2 : 3);
            int wanted = Math.Min(m_build.MaxSlots(JobsUtility.JobWorkerCount + 1), chunks);
            int workspaces = (int)Math.Max(1, Math.Min(wanted, plan.IndexBytes / m_chunkBytes));
            for (int i = 0; i < workspaces; i++)
                m_workspaces.Add(m_build.CreateWorkspace(m_store));
            long room = Math.Max(0, plan.IndexBytes - workspaces * m_chunkBytes) / 2 / m_inFlightBytes;
            int first =
                InFlightLimit.ValueFor(workspaces, m_build.InFlightMs(), workspaces, m_build.Plan.PointsPerChunk / PointsPerMs);
            m_limit = new InFlightLimit(first, (int)Math.Min(chunks, workspaces + room), m_build.InFlightMs);
            m_writes = new ChunkWrites(m_build.Folder, m_chunks, files, m_limit.Max);
        }

        /// <summary>Schedules a chunk's jobs after those of the workspace with the fewest points left.</summary>
        void Begin(int number)
        {
            var files = m_build.Files;
            var slot = m_idle.Count > 0 ? m_idle.Pop() : new Slot
            {
                Indexer = m_build.CreateIndexer(m_store, Manifest),
                Outside = new NativeReference<int>(Allocator.Persistent),
            };
            if (files != null)
                slot.Load ??= new RecordLoad(m_build, slot.Indexer.SliceTimes);
            m_inFlight.Enqueue(slot);
            var chunk = m_chunks.Chunks[number];
            slot.Chunk = number;
            slot.Workspace = m_workspaces[0];
            // There may be fewer workers by now than there are workspaces.
            for (int i = m_build.MaxSlots(m_workspaces.Count) - 1; i > 0; i--)
                if (m_workspaces[i].Points < slot.Workspace.Points)
                    slot.Workspace = m_workspaces[i];
            slot.Workspace.Points += chunk.Count;
            var ready = default(JobHandle);
            if (files != null)
            {
                slot.Load.Begin(chunk.Ranges, 0, chunk.Count);
                chunk.Pages = slot.Load.Pages;
                slot.Outside.Value = 0;
                ready = CheckRecordsJob.Schedule(new CheckRecordsJob
                {
                    SliceTimes = slot.Indexer.SliceTimes,
                    Pages = chunk.Pages,
                    Layout = m_build.RecordLayout,
                    Cube = chunk.Cube,
                    Outside = slot.Outside,
                }, slot.Load.Done);
            }
            var container = new ContainerRecord { Cube = chunk.Cube, Part = PartOf(number), Kind = ContainerKind.Chunk };
            slot.Indexer.Begin(container, chunk.Pages, number, slot.Workspace, ready);
            m_newest = slot.Indexer.Job;
        }

        /// <summary>Chunks of one cube have points at one place.</summary>
        int PartOf(int number)
        {
            int part = 0;
            while (number > part && m_chunks.Chunks[number - part - 1].Cube.Corner == m_chunks.Chunks[number].Cube.Corner &&
                m_chunks.Chunks[number - part - 1].Cube.SideLog2 == m_chunks.Chunks[number].Cube.SideLog2)
                part++;
            return part;
        }

        /// <summary>Not often, not much of the time, and only if there is memory for it beside the chunks in progress.</summary>
        bool IsGenerationDue(double seconds, double lastTook)
        {
            if (seconds < Math.Max(m_build.Settings.SecondsPerGeneration, 8 * lastTook))
                return false;
            long tops = 0;
            foreach (var result in m_results)
                tops += result == null ? 0 : result.TopPoints;
            var plan = m_build.Plan;
            long merged = Math.Min(tops, plan.PointsPerRegion) * plan.IndexBytesPerPoint;
            long inWork = m_workspaces.Count * m_chunkBytes + (m_limit.Value - m_workspaces.Count) * m_inFlightBytes;
            return tops > 0 && merged + inWork <= plan.IndexBytes;
        }

        IEnumerator<JobStep> WriteGeneration()
        {
            var cubes = new GridCube[m_results.Length];
            var finished = new ChunkResult[m_results.Length];
            for (int i = 0; i < m_results.Length; i++)
            {
                cubes[i] = m_chunks.Chunks[i].Cube;
                // A chunk whose file is still being written comes with the next generation.
                finished[i] = m_writes.HasPending(i) ? null : m_results[i];
            }
            return m_generations.Write(Manifest, m_store, cubes, finished, TopRecords);
        }

        /// <summary>Reads a chunk that the interrupted build finished; null if it did not. Any thread.</summary>
        ChunkResult ReadFinishedChunk(int chunk, int stride)
        {
            string path = m_build.Folder.PathOf(BuildFiles.TopPath(chunk));
            if (!System.IO.File.Exists(path))
                return null;
            using var bytes = StoreFile.Read(path, 0, StoreFile.SizeOf(path), Allocator.Persistent);
            var result = ChunkResult.FromBytes(bytes, chunk, Manifest.CloudId, BytesOfPlane.Length, stride);
            if (result == null)
                return null;
            string file = m_build.Folder.PathOf(StoreFormat.PathOf(result.Container));
            bool isWhole = !result.Top.HasNodes ||
                System.IO.File.Exists(file) && StoreFile.SizeOf(file) == result.Container.FileBytes;
            return isWhole ? result : null;
        }

        /// <summary>Takes in a chunk that is indexed, once there is room for one more file to be written.</summary>
        IEnumerator<JobStep> Finish(Slot slot)
        {
            slot.Indexer.Job.Complete();
            slot.Workspace.Points -= m_chunks.Chunks[slot.Chunk].Count;
            if (m_build.Files != null)
            {
                slot.Load.Complete();
                if (slot.Outside.Value > 0)
                    throw RecordLoad.Damaged(m_build.Files.PathOf(m_chunks.Chunks[slot.Chunk].Ranges[0].File));
            }
            m_writes.Poll(0);
            while (!m_writes.HasRoom)
            {
                m_writes.Poll(1);
                yield return default;
            }
            AddResults(slot);
            m_pointsDone += m_chunks.Chunks[slot.Chunk].Count;
            m_build.Progress?.Report(m_pointsDone / (double)m_points, m_pointsDone, 0);
        }

        void AddResults(Slot slot)
        {
            var indexer = slot.Indexer;
            var result = ChunkResult.Of(indexer);
            m_build.SliceTimes.TakeFrom(indexer.SliceTimes);
            m_results[slot.Chunk] = result;
            var pages = indexer.Pages;
            RecordPagePool.Of(m_build.Pool).Return(ref pages);
            m_chunks.Chunks[slot.Chunk].Pages = default;
            if (m_build.Files == null)
            {
                TopRecords[slot.Chunk] = new NativeArray<byte>(indexer.Top.AsArray(), Allocator.Persistent);
                result.Table = new NativeArray<byte>(indexer.Table.AsArray(), Allocator.Persistent);
            }
            indexer.File = m_writes.Write(result, indexer.File, m_build.Files == null ? default
                : result.ToBytes(indexer.Table.AsArray(), indexer.Top.AsArray(), Manifest.CloudId));
        }
    }

    /// <summary>Files of finished chunks that wait to be written, so that the next chunks need not wait for the disk. There are
    /// as many as memory allows: the caller gets an empty list in exchange.</summary>
    sealed class ChunkWrites : IDisposable
    {
        struct Pending
        {
            public int Chunk;
            public WriteTicket Written;
            public NativeList<byte> File;
            public NativeArray<byte> Top;
        }

        readonly CloudFolderWriter m_folder;
        readonly ChunkSet m_chunks;
        readonly RecordFiles m_files;
        readonly int m_max;
        readonly Queue<Pending> m_pending = new Queue<Pending>();
        readonly Stack<NativeList<byte>> m_idle = new Stack<NativeList<byte>>();

        /// <param name="files">Released when a chunk that came from them is on disk; null if all points are in memory.</param>
        /// <param name="max">The most files that may wait.</param>
        public ChunkWrites(CloudFolderWriter folder, ChunkSet chunks, RecordFiles files, int max)
        {
            m_folder = folder;
            m_chunks = chunks;
            m_files = files;
            m_max = max;
        }

        public bool HasRoom => m_pending.Count < m_max;

        public bool IsDone => m_pending.Count == 0;

        /// <summary>Queues a chunk's file and, if points are in files, what a resumed build has to know.</summary>
        /// <param name="file">The chunk's file; nothing is written if it is empty.</param>
        /// <param name="top">The chunk's top, or not created; this object takes it over.</param>
        /// <returns>An empty list in exchange for the file.</returns>
        public NativeList<byte> Write(ChunkResult chunk, NativeList<byte> file, NativeArray<byte> top)
        {
            var pending = new Pending { Chunk = chunk.Number, File = file, Top = top };
            if (file.Length > 0)
                pending.Written = m_folder.Write(StoreFormat.PathOf(chunk.Container), file.AsArray());
            // This comes after the chunk's own file: once it exists, the chunk is done.
            if (top.IsCreated)
                pending.Written = m_folder.Write(BuildFiles.TopPath(chunk.Number), top);
            if (pending.Written == null)
                return file;
            m_pending.Enqueue(pending);
            return m_idle.Count > 0 ? m_idle.Pop() : new NativeList<byte>(1024, Allocator.Persistent);
        }

        /// <summary>Takes back what has been written since; waits at most this long for the first file.</summary>
        public void Poll(int waitMs)
        {
            // They are written one after another.
            while (m_pending.Count > 0 && m_pending.Peek().Written.IsDone(waitMs))
            {
                var done = m_pending.Dequeue();
                waitMs = 0;
                done.File.Clear();
                m_idle.Push(done.File);
                if (!done.Top.IsCreated)
                    continue;
                done.Top.Dispose();
                foreach (var range in m_chunks.Chunks[done.Chunk].Ranges)
                    m_files.Release(range.File);
            }
        }

        public bool HasPending(int chunk)
        {
            foreach (var pending in m_pending)
                if (pending.Chunk == chunk)
                    return true;
            return false;
        }

        public void Dispose()
        {
            while (m_pending.Count > 0)
            {
                var pending = m_pending.Dequeue();
                pending.Written.WaitAndStopRetries();
                pending.File.Dispose();
                if (pending.Top.IsCreated)
                    pending.Top.Dispose();
            }
            while (m_idle.Count > 0)
                m_idle.Pop().Dispose();
        }
    }
}
