using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Base;
using FastPoints.Nodes;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Samplers;
using FastPoints.Store;
using FastPoints.Writing;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Convert
{
    /// <summary>
    /// Makes a build that is under way a cloud that can be opened, again and again: the finished chunks, and for the others
    /// what a sample shows of them, as chunks' tops that the same sampler made. A reader follows the generations of cloud.json.
    /// </summary>
    internal sealed class BuildGenerations : IDisposable
    {
        readonly ProvisionalSample m_sample;
        readonly CloudFolderWriter m_folder;
        readonly RecordLayout m_records;
        readonly Sampler m_sampler;
        readonly NodeSizes m_sizes;
        readonly SliceTimes m_slices;
        readonly long m_pointsPerRegion;
        readonly double m_secondsToFirst;
        readonly Stopwatch m_watch = Stopwatch.StartNew();
        readonly NativeReference<ulong> m_sum;
        long m_generation;

        /// <param name="sample">Read when it is needed first.</param>
        /// <param name="pointsPerRegion">See <see cref="UpperMerge.Run"/>.</param>
        /// <param name="secondsToFirst">A build that has read all its points before has no use for a generation without
        /// chunks.</param>
        public BuildGenerations(ProvisionalSample sample, CloudFolderWriter folder, RecordLayout records, Sampler sampler,
            NodeSizes sizes, long pointsPerRegion, double secondsToFirst, SliceTimes slices)
        {
            m_sample = sample;
            m_folder = folder;
            m_records = records;
            m_sampler = sampler;
            m_sizes = sizes;
            m_pointsPerRegion = pointsPerRegion;
            m_secondsToFirst = secondsToFirst;
            m_slices = slices;
            m_sum = new NativeReference<ulong>(Allocator.Persistent);
            // Readers know a newer state by a larger number, also one of a build that was continued.
            string text = folder.ReadText(StoreFormat.ManifestName);
            if (text != null)
                m_generation = CloudManifest.FromJson(text, folder.PathOf(StoreFormat.ManifestName)).Generation;
        }

        /// <summary>Whether it is time for the first generation, which has the sample alone.</summary>
        public bool IsFirstDue => m_generation == 0 && m_watch.Elapsed.TotalSeconds >= m_secondsToFirst;

        /// <summary>Work for a pump: makes the sample a cloud.</summary>
        /// <param name="cubes">Of the first partition, in Morton order.</param>
        /// <param name="describe">Fills in the manifest from what the sample shows.</param>
        public IEnumerator<Work> WriteFirst(GridCube root, IReadOnlyList<GridCube> cubes, Action<CloudManifest> describe)
        {
            if (!m_sample.IsRead)
                yield return Work.Of(m_sample.Read());
            var manifest = new CloudManifest { Root = root };
            describe(manifest);
            using (var store = new NativeStoreLayout(manifest.CreateLayout()))
                yield return Work.Of(Write(manifest, store, cubes, new ChunkResult[cubes.Count], new NativeArray<byte>[cubes.Count]));
        }

        /// <summary>Work for a pump: the next generation.</summary>
        /// <param name="whole">Of the cloud when it is whole: nothing of it is changed.</param>
        /// <param name="cubes">By chunk, in Morton order.</param>
        /// <param name="finished">By chunk: what lies on disk of it; null where it is not finished.</param>
        /// <param name="topRecords">By chunk: as in <see cref="UpperMerge.Run"/>.</param>
        public IEnumerator<Work> Write(CloudManifest whole, NativeStoreLayout store, IReadOnlyList<GridCube> cubes,
            IReadOnlyList<ChunkResult> finished, NativeArray<byte>[] topRecords)
        {
            if (!m_sample.IsRead)
                yield return Work.Of(m_sample.Read());
            var manifest = CloudManifest.FromJson(whole.ToJson(), m_folder.PathOf(StoreFormat.ManifestName));
            manifest.IsBuilding = true;
            manifest.Generation = ++m_generation;
            manifest.Points = 0;
            manifest.Checksum = 0;
            var results = new ChunkResult[finished.Count];
            var tops = (NativeArray<byte>[])topRecords.Clone();
            var provisional = new List<int>();
            try
            {
                yield return Work.Of(MakeTops(manifest, store, cubes, finished, results, tops, provisional));
                var chunks = new List<ChunkResult>();
                for (int i = 0; i < results.Length; i++)
                {
                    var result = finished[i] ?? results[i];
                    if (result == null)
                        continue;
                    chunks.Add(result);
                    manifest.Points += result.TopPoints + result.Record.PointCount;
                    manifest.Checksum += result.Checksum;
                }
                using (var merge = new UpperMerge(m_records, store, manifest.Root, manifest.CloudId, m_folder, m_sampler, m_sizes,
                    m_slices))
                    yield return Work.Of(merge.Run(chunks, tops, m_pointsPerRegion, manifest, null));
            }
            finally
            {
                foreach (int i in provisional)
                    tops[i].Dispose();
            }
            m_folder.WriteText(StoreFormat.ManifestName, manifest.ToJson());
            // The generation before is what a reader may just be opening.
            m_folder.DeleteGeneration(m_generation - 2);
        }

        public void Dispose()
        {
            m_sample.Dispose();
            if (m_sum.IsCreated)
                m_sum.Dispose();
        }

        /// <summary>A top of the sample for each chunk that is not finished. What the sampler leaves below a top is not
        /// shown.</summary>
        IEnumerator<Work> MakeTops(CloudManifest manifest, NativeStoreLayout store, IReadOnlyList<GridCube> cubes,
            IReadOnlyList<ChunkResult> finished, ChunkResult[] results, NativeArray<byte>[] tops, List<int> provisional)
        {
            var all = new GridCube[cubes.Count];
            for (int i = 0; i < all.Length; i++)
                all[i] = cubes[i];
            var native = new NativeArray<GridCube>(all, Allocator.Persistent);
            var parts = new NativeArray<RecordPages>(all.Length, Allocator.Persistent);
            var job = default(JobHandle);
            var indexer = new ChunkIndexer(m_records, store, manifest.Root.Corner, manifest.CloudId, m_sampler, m_sizes);
            try
            {
                job = m_sample.Distribute(native, manifest.Root.Corner, parts);
                yield return job;
                job.Complete();
                for (int i = 0; i < all.Length; i++)
                {
                    if (finished[i] != null || parts[i].Count == 0)
                        continue;
                    indexer.Begin(all[i], parts[i], i);
                    yield return indexer.Job;
                    indexer.Job.Complete();
                    job = new SumTopJob
                    {
                        Records = indexer.Top.AsArray(),
                        Layout = m_records.ForTops(store.HasAverages),
                        Sum = m_sum,
                    }.Schedule();
                    yield return job;
                    job.Complete();
                    m_slices.Take(indexer.Slices);
                    results[i] = ChunkResult.OfTop(indexer);
                    results[i].Checksum = m_sum.Value;
                    tops[i] = new NativeArray<byte>(indexer.Top.AsArray(), Allocator.Persistent);
                    provisional.Add(i);
                }
            }
            finally
            {
                job.Complete();
                indexer.Dispose();
                foreach (var part in parts)
                    m_sample.Return(part);
                parts.Dispose();
                native.Dispose();
            }
        }
    }
}
