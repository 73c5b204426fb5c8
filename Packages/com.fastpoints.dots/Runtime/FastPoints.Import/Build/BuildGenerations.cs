using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Makes a running build a cloud that can be opened, repeatedly: the finished chunks, and for the
    /// others what a sample shows of them, as chunks' tops that the same sampler made. A reader follows the generations of
    /// cloud.json.</summary>
    internal sealed class BuildGenerations : IDisposable
    {
        const int MaxTopsInFlight = 8;

        readonly BuildContext m_build;
        readonly PlaceholderSample m_sample;
        readonly Stopwatch m_watch = Stopwatch.StartNew();
        long m_generation;

        public BuildGenerations(BuildContext build)
        {
            m_build = build;
            m_sample = new PlaceholderSample(build);
            // Readers know a newer state by a larger number, also one of a build that was continued.
            string text = build.Folder.ReadText(StoreFormat.ManifestName);
            if (text != null)
                m_generation = CloudManifest.FromJson(text, build.Folder.PathOf(StoreFormat.ManifestName)).Generation;
        }

        /// <summary>Whether it is time for the first generation, which has the sample alone. A build that has read all its points
        /// before has no use for it.</summary>
        public bool IsFirstDue => m_generation == 0 && m_watch.Elapsed.TotalSeconds >= m_build.Settings.SecondsToFirstGeneration;

        public IEnumerator<JobStep> WriteFirst()
        {
            if (!m_sample.IsRead)
                yield return JobStep.Of(m_sample.Read());
            var manifest = CloudDescription.OfSample(m_build, m_sample);
            var cubes = m_build.Map.Chunks;
            using var store = new NativeStoreLayout(manifest.CreateLayout());
            yield return JobStep.Of(Write(manifest, store, cubes, new ChunkResult[cubes.Length],
                new NativeArray<byte>[cubes.Length]));
        }

        /// <summary>Coroutine: the next generation.</summary>
        /// <param name="cubes">By chunk, in Morton order.</param>
        /// <param name="topRecords">By chunk: as in <see cref="UpperMerge.Run"/>.</param>
        public IEnumerator<JobStep> Write(CloudManifest whole, NativeStoreLayout store, IReadOnlyList<GridCube> cubes,
            IReadOnlyList<ChunkResult> finished, NativeArray<byte>[] topRecords)
        {
            if (!m_sample.IsRead)
                yield return JobStep.Of(m_sample.Read());
            var manifest = whole.Clone();
            manifest.IsBuilding = true;
            manifest.Generation = ++m_generation;
            manifest.Points = 0;
            manifest.Checksum = 0;
            var results = new List<ChunkResult>(finished).ToArray();
            var tops = (NativeArray<byte>[])topRecords.Clone();
            var placeholders = new List<int>();
            try
            {
                yield return JobStep.Of(MakeTops(manifest, store, cubes, results, tops, placeholders));
                var chunks = new List<ChunkResult>();
                foreach (var result in results)
                {
                    if (result == null)
                        continue;
                    chunks.Add(result);
                    manifest.Points += result.TopPoints + result.FilePointCount;
                    manifest.Checksum += result.Checksum;
                }
                using var merge = new UpperMerge(m_build, store, manifest);
                yield return JobStep.Of(merge.Run(chunks, tops, null));
            }
            finally
            {
                foreach (int i in placeholders)
                    tops[i].Dispose();
            }
            yield return JobStep.Of(m_build.Folder.WriteText(StoreFormat.ManifestName, manifest.ToJson()));
            // A reader may be opening the previous generation.
            m_build.Folder.DeleteGeneration(m_generation - 2);
        }

        public void Dispose() => m_sample.Dispose();

        /// <summary>A top of the sample for each chunk that is not finished. Points below a top are not
        /// shown.</summary>
        IEnumerator<JobStep> MakeTops(CloudManifest manifest, NativeStoreLayout store, IReadOnlyList<GridCube> cubes,
            ChunkResult[] results, NativeArray<byte>[] tops, List<int> placeholders)
        {
            var all = new List<GridCube>(cubes).ToArray();
            var native = new NativeArray<GridCube>(all, Allocator.Persistent);
            var parts = new NativeArray<RecordPages>(all.Length, Allocator.Persistent);
            var job = default(JobHandle);
            var workspace = m_build.CreateWorkspace(store);
            var inWork = new Queue<ChunkIndexer>();
            var spare = new Stack<ChunkIndexer>();
            try
            {
                job = m_sample.Distribute(native, manifest.Root.Corner, parts);
                yield return job;
                job.Complete();
                long largest = 0;
                foreach (var part in parts)
                    largest = Math.Max(largest, part.RecordCount);
                workspace.Reserve((int)largest);
                for (int i = 0; i < all.Length || inWork.Count > 0;)
                {
                    if (i < all.Length && inWork.Count < MaxTopsInFlight)
                    {
                        if (results[i] == null && parts[i].RecordCount > 0)
                        {
                            var next = spare.Count > 0 ? spare.Pop() : m_build.CreateIndexer(store, manifest);
                            next.BeginTop(all[i], parts[i], i, workspace);
                            inWork.Enqueue(next);
                            // The coroutine checks its budget.
                            yield return default;
                        }
                        i++;
                        continue;
                    }
                    yield return inWork.Peek().Job;
                    var indexer = inWork.Dequeue();
                    spare.Push(indexer);
                    indexer.Job.Complete();
                    m_build.SliceTimes.TakeFrom(indexer.SliceTimes);
                    int c = indexer.Number;
                    results[c] = ChunkResult.OfTop(indexer);
                    results[c].Checksum = indexer.Checksum;
                    tops[c] = new NativeArray<byte>(indexer.Top.AsArray(), Allocator.Persistent);
                    placeholders.Add(c);
                }
            }
            finally
            {
                job.Complete();
                workspace.Dispose();
                foreach (var indexer in inWork)
                    indexer.Dispose();
                foreach (var indexer in spare)
                    indexer.Dispose();
                foreach (var part in parts)
                    m_sample.Return(part);
                parts.Dispose();
                native.Dispose();
            }
        }
    }
}
