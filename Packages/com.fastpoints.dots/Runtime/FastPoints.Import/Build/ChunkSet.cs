using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>All points of the cloud by chunk: disjoint cubes of the octree, in memory or in temporary files.</summary>
    internal sealed class ChunkSet : IDisposable
    {
        const int SplitLevels = 3;

        // A chunk whose points fill a smaller cube is counted in cells that are this many levels finer at first.
        const int SpareLevels = 2;
        public const int PagesPerBatch = 64;

        public sealed class Chunk
        {
            public GridCube Cube;

            public RecordPages Pages;

            /// <summary>Its records in files; either these or the pages are empty.</summary>
            public readonly List<RecordRange> Ranges = new List<RecordRange>();

            public long Count { get; private set; }

            public void Add(ref RecordPages pages)
            {
                Count += pages.RecordCount;
                Pages.Join(ref pages);
            }

            public void Add(RecordRange range)
            {
                Count += range.Count;
                Ranges.Add(range);
            }
        }

        readonly BuildContext m_build;
        readonly long m_maxPages;
        readonly RecordLoad m_load;
        readonly List<Chunk> m_chunks = new List<Chunk>();

        public ChunkSet(BuildContext build)
        {
            m_build = build;
            // The pages that pieces of chunks may take until they go to files.
            m_maxPages = build.Plan.MaxPages / 2;
            m_load = new RecordLoad(build, build.SliceTimes);
        }

        public IReadOnlyList<Chunk> Chunks => m_chunks;

        RecordFiles Files => m_build.Files;

        /// <summary>Creates the coroutine to run after each completed change, when the chunks and their records agree. Files that
        /// are no longer needed exist until it has ended.</summary>
        public Func<IEnumerator<JobStep>> OnRebalanced { get; set; }

        public void Add(GridCube cube, ref RecordPages pages)
        {
            if (pages.RecordCount > 0)
            {
                var chunk = new Chunk { Cube = cube };
                chunk.Add(ref pages);
                m_chunks.Add(chunk);
            }
            pages = default;
        }

        public void Add(GridCube cube, int file)
        {
            if (Files.RecordsOf(file) > 0)
                Add(cube, new RecordRange { File = file, Count = Files.RecordsOf(file) });
        }

        public void Add(GridCube cube, params RecordRange[] ranges)
        {
            var chunk = new Chunk { Cube = cube };
            foreach (var range in ranges)
                chunk.Add(range);
            m_chunks.Add(chunk);
        }

        public IEnumerator<JobStep> SplitOutside(BaseCells cells, Chunk outside) =>
            Distribute(outside, cells.Around, cells.Root.Corner);

        /// <summary>Coroutine: packs pages, and writes them to a file that stays with the build.</summary>
        /// <param name="written">Receives their bytes.</param>
        public IEnumerator<JobStep> Write(string name, RecordPages pages, long offset, Action<long> written)
        {
            yield return JobStep.Of(JobStep.Await(PackRecordsJob.Schedule(new PackRecordsJob
            {
                Pages = pages,
                StrideBytes = m_build.RecordLayout.StrideBytes,
                SliceTimes = m_build.SliceTimes,
            }, default)));
            yield return JobStep.Of(CloudFolderWriter.Await(m_build.Folder.WriteRecords(name, pages, offset)));
            written(new RecordBlocks(name, 0).Add(pages));
        }

        /// <summary>Coroutine: writes the records of the chunk outside of all to a file of the build, and takes it out.</summary>
        public IEnumerator<JobStep> SetAside(Chunk chunk)
        {
            m_chunks.Remove(chunk);
            long done = 0, written = 0;
            m_build.Folder.Truncate(BuildFiles.OutsideName, 0);
            while (done < chunk.Count)
            {
                var pages = chunk.Pages;
                chunk.Pages = default;
                if (chunk.Ranges.Count > 0)
                {
                    BeginBatch(chunk, done);
                    yield return m_load.Done;
                    pages = m_load.Complete();
                }
                yield return JobStep.Of(Write(BuildFiles.OutsideName, pages, written, bytes => written += bytes));
                done += pages.RecordCount;
                Return(ref pages);
            }
            yield return JobStep.Of(CloudFolderWriter.Await(m_build.Folder.SyncRecords(BuildFiles.OutsideName)));
            foreach (var range in chunk.Ranges)
                Files.Release(range.File);
        }

        /// <summary>Coroutine: splits chunks that are larger than a base cell, or have more than <paramref name="target"/>
        /// points, until none is left. Points at one position are split by count, in their order.</summary>
        public IEnumerator<JobStep> SplitLarge(BaseCells cells, long target)
        {
            // Pieces are added at the end and examined in turn.
            for (int i = 0; i < m_chunks.Count;)
            {
                var chunk = m_chunks[i];
                if (!cells.At(chunk.Cube.Corner).ContainsAligned(chunk.Cube))
                    yield return JobStep.Of(Distribute(chunk, cells.In(chunk.Cube), chunk.Cube.Corner));
                else if (chunk.Count > (chunk.Cube.SideLog2 == 0 ? RecordsPerPiece(target) : target))
                    yield return JobStep.Of(Split(chunk, target));
                else
                    i++;
            }
        }

        /// <summary>Makes each chunk the largest cube of a base cell that has no more than <paramref name="target"/> points, and
        /// puts all in Morton order.</summary>
        /// <param name="root">The cube of all points.</param>
        public void MergeSmall(GridCube root, BaseCells cells, long target)
        {
            // The order is stable: several chunks of one cube keep the order of their points.
            var order = new int[m_chunks.Count];
            for (int i = 0; i < order.Length; i++)
                order[i] = i;
            Array.Sort(order, (a, b) =>
            {
                int byPosition = MortonOrder.Compare(m_chunks[a].Cube.Corner - root.Corner,
                    m_chunks[b].Cube.Corner - root.Corner);
                return byPosition != 0 ? byPosition : a.CompareTo(b);
            });
            var sorted = Array.ConvertAll(order, i => m_chunks[i]);
            m_chunks.Clear();
            for (int first = 0, end = 0; first < sorted.Length; first = end)
            {
                var cell = cells.At(sorted[first].Cube.Corner);
                while (end < sorted.Length && cell.Contains(sorted[end].Cube.Corner))
                    end++;
                Merge(cell.ContainsAligned(root) ? root : cell, new ArraySegment<Chunk>(sorted, first, end - first), target);
            }
        }

        void Merge(GridCube cube, IReadOnlyList<Chunk> chunks, long target)
        {
            foreach (var group in CubeGroups.Of(cube, chunks, c => c.Cube, c => c.Count, target))
            {
                var first = chunks[group.First];
                // Those that are split by count keep the cube of one position.
                if (first.Count <= target && first.Cube.SideLog2 > 0)
                    first.Cube = group.Cube;
                for (int i = group.First + 1; i < group.First + group.Count; i++)
                {
                    first.Add(ref chunks[i].Pages);
                    foreach (var range in chunks[i].Ranges)
                        first.Add(range);
                }
                m_chunks.Add(first);
            }
        }

        public void Dispose() => m_load.Dispose();

        IEnumerator<JobStep> Split(Chunk chunk, long target)
        {
            var bounds = new NativeArray<Grid3>(2, Allocator.Persistent);
            var counts = default(NativeArray<long>);
            try
            {
                bounds[0] = PointStatistics.None.Min;
                bounds[1] = PointStatistics.None.Max;
                int levels;
                CellFinder cells;
                do
                {
                    var cube = chunk.Cube;
                    levels = PartitionMap.LevelsFor(cube.SideLog2, SplitLevels + SpareLevels);
                    cells = new CellFinder(cube, levels);
                    if (counts.IsCreated)
                        counts.Dispose();
                    counts = new NativeArray<long>(1 << 3 * levels, Allocator.Persistent);
                    var job = new CountCellPointsJob
                    {
                        SliceTimes = m_build.SliceTimes,
                        Layout = m_build.RecordLayout,
                        Cells = cells,
                        PointsOfCell = counts,
                        Bounds = bounds,
                    };
                    yield return JobStep.Of(ForEachBatch(chunk, (pages, before) =>
                    {
                        job.Pages = pages;
                        return job.Schedule(before);
                    }));
                    chunk.Cube = RootCube.Shrink(cube, bounds[0], bounds[1]);
                    levels -= cube.SideLog2 - chunk.Cube.SideLog2;
                }
                while (chunk.Cube.SideLog2 > 0 && levels < PartitionMap.LevelsFor(chunk.Cube.SideLog2, SplitLevels));
                if (chunk.Cube.SideLog2 == 0)
                {
                    SplitByCount(chunk, target);
                    yield return JobStep.Of(RunOnRebalanced());
                    yield break;
                }
                var corner = chunk.Cube.Corner;
                using var map = PartitionMap.Plan(chunk.Cube, levels,
                    counts.GetSubArray(cells.CellOf(corner.X, corner.Y, corner.Z), 1 << 3 * levels), target);
                yield return JobStep.Of(Distribute(chunk, map.Chunks, corner));
            }
            finally
            {
                if (counts.IsCreated)
                    counts.Dispose();
                bounds.Dispose();
            }
        }

        /// <summary>Splits into pieces of whole pages, so that they are the same in memory and in files.</summary>
        void SplitByCount(Chunk chunk, long target)
        {
            int pagesPerPiece = (int)(RecordsPerPiece(target) / RecordPages.RecordsPerPage);
            m_chunks.Remove(chunk);
            while (chunk.Pages.RecordCount > 0)
            {
                var piece = chunk.Pages.DetachFirst(pagesPerPiece);
                Add(chunk.Cube, ref piece);
            }
            long recordsPerPiece = RecordsPerPiece(target), room = 0;
            foreach (var range in chunk.Ranges)
            {
                for (long done = 0; done < range.Count;)
                {
                    if (room == 0)
                    {
                        m_chunks.Add(new Chunk { Cube = chunk.Cube });
                        room = recordsPerPiece;
                    }
                    long count = Math.Min(room, range.Count - done);
                    var piece = new RecordRange { File = range.File, First = range.First + done, Count = count };
                    m_chunks[m_chunks.Count - 1].Add(piece);
                    Files.AddUser(range.File);
                    done += count;
                    room -= count;
                }
                Files.Release(range.File);
            }
        }

        static long RecordsPerPiece(long target) =>
            Math.Max(1, target / RecordPages.RecordsPerPage) * RecordPages.RecordsPerPage;

        IEnumerator<JobStep> RunOnRebalanced()
        {
            if (OnRebalanced == null)
                yield break;
            yield return JobStep.Of(OnRebalanced());
        }

        IEnumerator<JobStep> AwaitWrites(long pages)
        {
            while (Files.PagesWaiting > pages)
            {
                Files.Poll(1);
                yield return default;
            }
        }

        IEnumerator<JobStep> Distribute(Chunk chunk, GridCube[] cubes, Grid3 corner)
        {
            var cubesOfLists = new NativeArray<GridCube>(cubes, Allocator.Persistent);
            var lists = new NativeArray<RecordPages>(cubes.Length, Allocator.Persistent);
            var fileOfList = new int[cubes.Length];
            bool isStored = chunk.Ranges.Count > 0;
            var job = default(JobHandle);
            JobHandle Schedule(RecordPages pages, JobHandle before) => new DistributeRecordsJob
            {
                Pages = pages,
                TakesPages = true,
                Layout = m_build.RecordLayout,
                Cubes = cubesOfLists,
                Corner = corner,
                Chunks = lists,
                Pool = m_build.Pool,
                SliceTimes = m_build.SliceTimes,
            }.Schedule(before);
            try
            {
                for (int i = 0; i < fileOfList.Length && isStored; i++)
                    fileOfList[i] = Files.Add();
                if (!isStored)
                {
                    while (chunk.Pages.PageCount > 0)
                        job = Schedule(chunk.Pages.DetachFirst(DistributeRecordsJob.PagesPerSlice), job);
                    yield return job;
                    job.Complete();
                }
                if (isStored)
                    BeginBatch(chunk, 0);
                for (long first = 0; isStored && first < chunk.Count; first += PagesPerBatch * RecordPages.RecordsPerPage)
                {
                    yield return m_load.Done;
                    var loaded = m_load.Complete();
                    // While one batch is distributed, the next is read and unpacked.
                    if (first + PagesPerBatch * RecordPages.RecordsPerPage < chunk.Count)
                        BeginBatch(chunk, first + PagesPerBatch * RecordPages.RecordsPerPage);
                    while (loaded.PageCount > 0)
                        job = Schedule(loaded.DetachFirst(DistributeRecordsJob.PagesPerSlice), job);
                    yield return job;
                    job.Complete();
                    if (m_build.Pool.Value.PagesInUse > m_maxPages)
                        AppendLists(lists, fileOfList, false);
                    if (Files.PagesWaiting > m_maxPages)
                        yield return JobStep.Of(AwaitWrites(m_maxPages));
                    ReturnWritten();
                }
                if (isStored)
                {
                    AppendLists(lists, fileOfList, true);
                    yield return JobStep.Of(AwaitWrites(0));
                    Files.AddSliceTimesTo(m_build.SliceTimes);
                }
                m_chunks.Remove(chunk);
                for (int i = 0; i < cubes.Length; i++)
                {
                    var pages = lists[i];
                    lists[i] = default;
                    if (isStored)
                        Add(cubes[i], fileOfList[i]);
                    else
                        Add(cubes[i], ref pages);
                }
                ReturnWritten();
                yield return JobStep.Of(RunOnRebalanced());
                foreach (var range in chunk.Ranges)
                    Files.Release(range.File);
            }
            finally
            {
                job.Complete();
                lists.Dispose();
                cubesOfLists.Dispose();
            }
        }

        /// <summary>Runs work on all records of a chunk, which stay in place.</summary>
        IEnumerator<JobStep> ForEachBatch(Chunk chunk, Func<RecordPages, JobHandle, JobHandle> schedule)
        {
            var job = default(JobHandle);
            var batches = new List<RecordPages>();
            try
            {
                if (chunk.Ranges.Count == 0)
                {
                    batches = SplitBatches(chunk.Pages);
                    chunk.Pages = default;
                    foreach (var batch in batches)
                        job = schedule(batch, job);
                    yield return job;
                    yield break;
                }
                for (long first = 0; first < chunk.Count; first += PagesPerBatch * RecordPages.RecordsPerPage)
                {
                    BeginBatch(chunk, first);
                    yield return m_load.Done;
                    var pages = m_load.Complete();
                    job = schedule(pages, default);
                    yield return job;
                    job.Complete();
                    Return(ref pages);
                }
            }
            finally
            {
                job.Complete();
                if (batches.Count > 0)
                    chunk.Pages = Join(batches);
            }
        }

        public static RecordPages Join(List<RecordPages> batches)
        {
            var all = default(RecordPages);
            foreach (var batch in batches)
            {
                var pages = batch;
                all.Join(ref pages);
            }
            return all;
        }

        public static List<RecordPages> SplitBatches(RecordPages pages)
        {
            var batches = new List<RecordPages>();
            while (pages.PageCount > 0)
                batches.Add(pages.DetachFirst(PagesPerBatch));
            return batches;
        }

        void BeginBatch(Chunk chunk, long first) =>
            m_load.Begin(chunk.Ranges, first, Math.Min(PagesPerBatch * RecordPages.RecordsPerPage, chunk.Count - first));

        void AppendLists(NativeArray<RecordPages> lists, int[] fileOfList, bool all)
        {
            for (int i = 0; i < lists.Length; i++)
            {
                var list = lists[i];
                Files.Append(fileOfList[i], all ? list.DetachFirst(list.PageCount) : list.DetachFull());
                lists[i] = list;
            }
        }

        void ReturnWritten()
        {
            if (Files == null)
                return;
            Files.Poll(0);
            var written = Files.RemoveWritten();
            Return(ref written);
        }

        void Return(ref RecordPages pages) => RecordPagePool.Of(m_build.Pool).Return(ref pages);
    }
}
