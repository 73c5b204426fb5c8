using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Nodes;
using FastPoints.Partition;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Samplers;
using FastPoints.Store;
using FastPoints.Writing;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Convert
{
    /// <summary>From chunks of records to a stored octree: each chunk into its file, the tops of all into the upper
    /// levels.</summary>
    internal sealed class OctreeBuild : IDisposable
    {
        /// <summary>A chunk in work, and what comes of it.</summary>
        sealed class Slot : IDisposable
        {
            public ChunkIndexer Indexer;
            public RecordLoad Load;
            public int Chunk = -1;

            public void Dispose()
            {
                Load?.Dispose();
                Indexer.Dispose();
            }
        }

        readonly ChunkSet m_chunks;
        readonly RecordLayout m_records;
        readonly NativeStoreLayout m_store;
        readonly GridCube m_root;
        readonly ulong m_cloudId;
        readonly CloudFolderWriter m_folder;
        readonly RecordFiles m_files;
        readonly MemoryPlan m_plan;
        readonly Sampler m_sampler;
        readonly NodeSizes m_sizes;
        readonly BuildGenerations m_generations;
        readonly double m_secondsPerGeneration;
        readonly SliceTimes m_slices;
        readonly List<Slot> m_slots = new List<Slot>();
        readonly ChunkResult[] m_results;
        readonly NativeArray<byte>[] m_topRecords;
        readonly NativeReference<RecordPagePool> m_pool;
        ChunkWrites m_writes;
        UpperMerge m_merge;
        long m_largestChunkBytes;
        int m_atOnce;

        /// <param name="pool">Of the chunks' pages.</param>
        /// <param name="files">Where their records are; null where they are in memory.</param>
        /// <param name="generations">Shows what is finished meanwhile.</param>
        public OctreeBuild(ChunkSet chunks, NativeReference<RecordPagePool> pool, RecordFiles files, MemoryPlan plan,
            RecordLayout records, NativeStoreLayout store, GridCube root, ulong cloudId, CloudFolderWriter folder,
            Sampler sampler, NodeSizes sizes, BuildGenerations generations, double secondsPerGeneration, SliceTimes slices)
        {
            m_chunks = chunks;
            m_pool = pool;
            m_files = files;
            m_plan = plan;
            m_records = records;
            m_store = store;
            m_root = root;
            m_cloudId = cloudId;
            m_folder = folder;
            m_sampler = sampler;
            m_sizes = sizes;
            m_generations = generations;
            m_secondsPerGeneration = secondsPerGeneration;
            m_slices = slices;
            m_results = new ChunkResult[chunks.Chunks.Count];
            m_topRecords = new NativeArray<byte>[m_results.Length];
            BytesOfPlane = new long[store.Layout.Planes.Count];
        }

        /// <summary>Sum of the hashes of all points that were written.</summary>
        public ulong Checksum { get; private set; }
        public int LevelCount { get; private set; }
        public long[] BytesOfPlane { get; }

        /// <summary>Work for a pump: every chunk, several at once; then the upper levels and the hierarchy.</summary>
        /// <param name="atOnce">Chunks in work, where memory has room for them.</param>
        public IEnumerator<Work> Run(int atOnce, CloudManifest manifest, StageProgress progress)
        {
            progress?.Begin(BuildStages.Index);
            yield return Work.Of(IndexChunks(atOnce, manifest, progress));
            foreach (var slot in m_slots)
                slot.Dispose();
            m_slots.Clear();
            m_writes.Dispose();
            RecordPagePool.Of(m_pool).FreeAll();

            progress?.Begin(BuildStages.Merge);
            int lowest = m_root.SideLog2;
            foreach (var result in m_results)
            {
                Checksum += result.Checksum;
                lowest = Math.Min(lowest, result.LowestSideLog2);
                for (int p = 0; p < BytesOfPlane.Length; p++)
                    BytesOfPlane[p] += result.BytesOfPlane[p];
            }
            m_merge = new UpperMerge(m_records, m_store, m_root, m_cloudId, m_folder, m_sampler, m_sizes, m_slices);
            yield return Work.Of(m_merge.Run(m_results, m_topRecords, m_plan.PointsPerChunk, manifest, progress));
            for (int p = 0; p < BytesOfPlane.Length; p++)
                BytesOfPlane[p] += m_merge.BytesOfPlane[p];
            LevelCount = m_results.Length == 0 ? 0 : m_root.SideLog2 - Math.Min(lowest, m_merge.LowestSideLog2) + 1;
        }

        public void Dispose()
        {
            foreach (var slot in m_slots)
                slot.Dispose();
            m_slots.Clear();
            m_writes?.Dispose();
            m_merge?.Dispose();
            for (int i = 0; i < m_topRecords.Length; i++)
            {
                if (m_topRecords[i].IsCreated)
                    m_topRecords[i].Dispose();
                m_topRecords[i] = default;
            }
        }

        IEnumerator<Work> IndexChunks(int atOnce, CloudManifest manifest, StageProgress progress)
        {
            var watch = System.Diagnostics.Stopwatch.StartNew();
            double mergeSeconds = 0;
            int finished = 0;
            // The largest first, so that none is left for the end alone.
            var order = new List<int>();
            long total = 0, done = 0, largest = 1;
            for (int i = 0; i < m_results.Length; i++)
            {
                long count = m_chunks.Chunks[i].Count;
                total += count;
                largest = Math.Max(largest, count);
                if (m_files != null && TakeOver(i))
                    done += count;
                else
                    order.Add(i);
            }
            order.Sort((a, b) =>
            {
                int bySize = m_chunks.Chunks[b].Count.CompareTo(m_chunks.Chunks[a].Count);
                return bySize != 0 ? bySize : a.CompareTo(b);
            });
            long chunkBytes = largest * m_plan.IndexBytesPerPoint;
            if (m_files == null)
                chunkBytes -= largest * m_records.StrideBytes;
            atOnce = (int)Math.Max(1, Math.Min(Math.Min(atOnce, order.Count), m_plan.IndexBytes / chunkBytes));
            m_largestChunkBytes = chunkBytes;
            m_atOnce = atOnce;
            for (int i = 0; i < atOnce; i++)
            {
                m_slots.Add(new Slot
                {
                    Indexer = new ChunkIndexer(m_records, m_store, m_root.Corner, m_cloudId, m_sampler, m_sizes),
                    Load = m_files == null ? null : new RecordLoad(m_files, m_pool),
                });
            }
            m_writes = new ChunkWrites(m_folder, m_chunks, m_files, atOnce);
            var bounds = new NativeArray<Grid3>(2, Allocator.Persistent);
            var check = default(JobHandle);
            try
            {
                for (int i = 0; i < order.Count + atOnce; i++)
                {
                    var slot = m_slots[i % atOnce];
                    if (i >= atOnce)
                    {
                        yield return slot.Indexer.Job;
                        slot.Indexer.Job.Complete();
                        m_writes.Poll(0);
                        while (!m_writes.HasRoom)
                        {
                            m_writes.Poll(1);
                            yield return default;
                        }
                        Finish(slot);
                        done += m_chunks.Chunks[slot.Chunk].Count;
                        progress?.Report(done / (double)total, done, 0);
                        finished++;
                    }
                    if (finished < order.Count && IsGenerationDue(watch.Elapsed.TotalSeconds, mergeSeconds))
                    {
                        double begin = watch.Elapsed.TotalSeconds;
                        yield return Work.Of(WriteGeneration(manifest));
                        mergeSeconds = watch.Elapsed.TotalSeconds - begin;
                        watch.Restart();
                    }
                    if (i >= order.Count)
                        continue;
                    slot.Chunk = order[i];
                    var chunk = m_chunks.Chunks[slot.Chunk];
                    if (m_files != null)
                    {
                        slot.Load.Begin(chunk.Runs, 0, chunk.Count);
                        yield return slot.Load.Done;
                        chunk.Pages = slot.Load.Complete();
                        // What comes from a disk is checked before anything is computed with it.
                        bounds[0] = PointStatistics.None.Min;
                        bounds[1] = PointStatistics.None.Max;
                        var batches = ChunkSet.CutBatches(chunk.Pages);
                        foreach (var batch in batches)
                            check = new MeasureRecordsJob
                            {
                                Slices = slot.Indexer.Slices,
                                Pages = batch,
                                Layout = m_records,
                                Bounds = bounds,
                            }.Schedule(check);
                        yield return check;
                        check.Complete();
                        chunk.Pages = ChunkSet.Join(batches);
                        if (!chunk.Cube.Contains(bounds[0]) || !chunk.Cube.Contains(bounds[1]))
                            throw new PointCloudException(FailureCode.ReadFailed, m_files.PathOf(chunk.Runs[0].File), -1,
                                "the points that were set aside there are damaged: delete the folder, and start again");
                    }
                    slot.Indexer.Begin(chunk.Cube, chunk.Pages, slot.Chunk);
                }
                while (!m_writes.IsDone)
                {
                    m_writes.Poll(1);
                    yield return default;
                }
            }
            finally
            {
                check.Complete();
                bounds.Dispose();
            }
        }

        /// <summary>Not often, not much of the time, and only where memory has room beside the chunks in work.</summary>
        bool IsGenerationDue(double seconds, double lastTook)
        {
            if (seconds < Math.Max(m_secondsPerGeneration, 8 * lastTook))
                return false;
            long tops = 0;
            foreach (var result in m_results)
                tops += result == null ? 0 : result.TopPoints;
            long merged = Math.Min(tops, UpperMerge.MostPointsAtOnce(m_plan.PointsPerChunk)) * m_plan.IndexBytesPerPoint;
            return tops > 0 && merged + m_atOnce * m_largestChunkBytes <= m_plan.IndexBytes;
        }

        /// <summary>Makes what is finished a cloud that can be opened.</summary>
        IEnumerator<Work> WriteGeneration(CloudManifest whole)
        {
            var cubes = new GridCube[m_results.Length];
            var finished = new ChunkResult[m_results.Length];
            for (int i = 0; i < m_results.Length; i++)
            {
                cubes[i] = m_chunks.Chunks[i].Cube;
                // A chunk whose file is still being written comes with the next generation.
                finished[i] = m_writes.HasPending(i) ? null : m_results[i];
            }
            return m_generations.Write(whole, m_store, cubes, finished, m_topRecords);
        }

        /// <summary>A chunk that the build before this one has done.</summary>
        bool TakeOver(int chunk)
        {
            string path = m_folder.PathOf(BuildFiles.TopPath(chunk));
            if (!System.IO.File.Exists(path))
                return false;
            using (var bytes = StoreFile.Read(path, 0, StoreFile.SizeOf(path), Allocator.Persistent))
            {
                var result = ChunkResult.FromBytes(bytes, m_cloudId, BytesOfPlane.Length,
                    m_records.ForTops(m_store.HasAverages).StrideBytes);
                if (result == null || result.Record.Number != chunk)
                    return false;
                string file = m_folder.PathOf(StoreFormat.ChunkPath(chunk));
                if (result.Top.HasNodes && (!System.IO.File.Exists(file) || StoreFile.SizeOf(file) != result.Record.FileBytes))
                    return false;
                m_results[chunk] = result;
            }
            foreach (var run in m_chunks.Chunks[chunk].Runs)
                m_files.Release(run.File);
            return true;
        }

        void Finish(Slot slot)
        {
            var indexer = slot.Indexer;
            var result = ChunkResult.Of(indexer);
            m_slices.Take(indexer.Slices);
            m_results[slot.Chunk] = result;
            var pages = indexer.Pages;
            RecordPagePool.Of(m_pool).Return(ref pages);
            m_chunks.Chunks[slot.Chunk].Pages = default;
            if (m_files == null)
                m_topRecords[slot.Chunk] = new NativeArray<byte>(indexer.Top.AsArray(), Allocator.Persistent);
            indexer.File = m_writes.Write(slot.Chunk, indexer.File,
                m_files == null ? default : result.ToBytes(indexer.Top.AsArray(), m_cloudId));
        }
    }
}
