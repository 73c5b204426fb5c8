using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Base;
using FastPoints.Draw;
using FastPoints.Files;
using FastPoints.Nodes;
using FastPoints.Partition;
using FastPoints.Picture;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Samplers;
using FastPoints.Store;
using FastPoints.Writing;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Convert
{
    /// <summary>
    /// From files to a stored octree. A sample guesses how dense the cloud is where; one pass over the points distributes them
    /// over chunks; chunks that came out too large are split, small ones merged; each is made into nodes; their tops become the
    /// upper levels.
    /// </summary>
    public sealed class ConvertCloud : IDisposable
    {
        readonly IReadOnlyList<PointReader> m_readers;
        readonly ConvertSettings m_settings;
        readonly StageProgress m_progress;
        readonly string m_target;
        readonly CloudFolderWriter m_folder;
        readonly List<SourceSample> m_samples = new List<SourceSample>();
        readonly List<SampleStatistics> m_sampleStatistics = new List<SampleStatistics>();
        readonly CloudManifest m_manifest = new CloudManifest();

        readonly PointSchema m_attributes;
        readonly SliceTimes m_slices;
        GridChoice m_grid;
        MemoryPlan m_plan;
        NativeReference<RecordPagePool> m_pool;
        RecordFiles m_files;
        BuildCheckpoints m_checkpoints;
        BuildGenerations m_generations;
        ProvisionalSample m_provisional;
        BuildJournal m_journal;
        long m_points;
        PartitionMap m_map;
        ScatterPoints m_scatter;
        ChunkSet m_chunks;
        NativeStoreLayout m_store;
        OctreeBuild m_build;

        ConvertCloud(IReadOnlyList<PointReader> readers, string target, ConvertSettings settings, StageProgress progress)
        {
            m_readers = readers;
            m_settings = settings;
            m_progress = progress;
            m_target = target;
            m_attributes = AttributeChoice.Of(readers, settings.Attributes);
            m_folder = new CloudFolderWriter(target);
            m_slices = new SliceTimes(Allocator.Persistent);
            m_manifest.Sampler = settings.Sampler.ToString().ToLowerInvariant();
        }

        /// <summary>Work for a pump: converts. The target is there, whole, when the work has ended; nothing is there when it was
        /// cancelled or failed, but for what <see cref="ConvertSettings.KeepUnfinished"/> keeps.</summary>
        /// <param name="readers">The sources: open, of the same attributes. They make one cloud.</param>
        /// <param name="target">The folder to make.</param>
        /// <param name="done">Gets what was made.</param>
        /// <exception cref="PointCloudException">A source or the target is at fault.</exception>
        public static IEnumerator<Work> Run(IReadOnlyList<PointReader> readers, string target, ConvertSettings settings,
            Action<ConvertResult> done, StageProgress progress)
        {
            using (var convert = new ConvertCloud(readers, target, settings, progress))
            {
                progress?.Begin(BuildStages.Sample);
                yield return Work.Of(convert.Sample());
                yield return Work.Of(convert.Partition());
                convert.Resume();
                if (convert.m_journal.At == BuildJournal.Stage.Done)
                {
                    progress?.Begin(BuildStages.Finish);
                    done(convert.Finish());
                    progress?.End();
                    yield break;
                }
                progress?.Begin(BuildStages.Read);
                yield return Work.Of(convert.Distribute());
                progress?.Begin(BuildStages.Split);
                yield return Work.Of(convert.SettleChunks());
                yield return Work.Of(convert.Build());
                progress?.Begin(BuildStages.Finish);
                yield return Work.Of(convert.MeasureShown());
                done(convert.Finish());
                progress?.End();
            }
        }

        public void Dispose()
        {
            m_build?.Dispose();
            m_generations?.Dispose();
            m_store?.Dispose();
            m_chunks?.Dispose();
            m_scatter?.Dispose();
            m_map?.Dispose();
            m_checkpoints?.Dispose();
            m_files?.Dispose();
            m_slices.Dispose();
            if (m_pool.IsCreated)
            {
                RecordPagePool.Of(m_pool).FreeAll();
                m_pool.Dispose();
            }
            foreach (var sample in m_samples)
                sample.Dispose();
            m_samples.Clear();
            if (m_settings.KeepUnfinished)
                m_folder.Keep();
            m_folder.Dispose();
        }

        NodeSizes Sizes
        {
            get
            {
                var sizes = NodeSizes.Default;
                if (m_settings.CellsLog2 > 0)
                    sizes.CellsLog2 = m_settings.CellsLog2;
                if (m_settings.MaxPointsPerLeaf > 0)
                    sizes.MaxPointsPerLeaf = m_settings.MaxPointsPerLeaf;
                return sizes;
            }
        }

        int MostSlots(int slots) => m_settings.Workers > 0 ? Math.Min(slots, m_settings.Workers) : slots;

        IEnumerator<Work> Sample()
        {
            var statistics = new NativeReference<SampleStatistics>(Allocator.Persistent);
            var job = default(JobHandle);
            try
            {
                foreach (var reader in m_readers)
                {
                    reader.MostJobs = m_settings.Workers;
                    if (!reader.BlocksAreKnown)
                        yield return Work.Of(reader.FindBlocks());
                    yield return Work.Of(SourceSample.Read(reader, MostSlots(SourceScan.DefaultSlots), m_samples.Add));
                    job = new MeasureSampleJob { Stored = m_samples[m_samples.Count - 1].Stored, Statistics = statistics }.Schedule();
                    yield return job;
                    job.Complete();
                    m_sampleStatistics.Add(statistics.Value);
                }
            }
            finally
            {
                job.Complete();
                statistics.Dispose();
            }
        }

        /// <summary>The grid, the first cube, and the chunks as the sample suggests them.</summary>
        IEnumerator<Work> Partition()
        {
            var infos = new List<SourceInfo>();
            foreach (var reader in m_readers)
            {
                infos.Add(reader.Info);
                m_points += reader.PointCount;
            }
            m_grid = GridChoice.Choose(infos, m_sampleStatistics, m_attributes.BytesPerPoint);
            int stride = m_grid.Records.StrideBytes;
            m_plan = MemoryPlan.For(m_points, stride, m_settings);
            m_pool = new NativeReference<RecordPagePool>(new RecordPagePool(stride, m_points / RecordPages.RecordsPerPage),
                Allocator.Persistent);

            var cube = FirstCube.Of(m_readers, m_sampleStatistics, m_grid);
            yield return Work.Of(PartitionPlan.Of(cube, m_samples, m_grid, m_points, m_plan, map => m_map = map));
            foreach (var sample in m_samples)
                sample.Dispose();
            m_samples.Clear();
        }

        /// <summary>Takes up the build that was killed, where there is one of the same sources and settings, and its points are
        /// on disk.</summary>
        void Resume()
        {
            m_files = m_plan.IsStored ? new RecordFiles(m_folder, m_grid.Records.StrideBytes) : null;
            m_scatter = new ScatterPoints(m_attributes, m_grid.Records, m_map, m_pool, m_files, m_plan, m_points, m_slices,
                m_progress);
            m_chunks = new ChunkSet(m_grid.Records, m_pool, m_files, m_plan.MostPages / 2, m_slices);
            ulong identity = BuildIdentity.Of(m_readers, m_attributes, m_grid, m_plan, m_map, m_settings);
            m_checkpoints = BuildCheckpoints.Resume(identity, m_folder, m_files, m_readers.Count, m_attributes.Count,
                m_map.Chunks.Length + 1, m_points);
            m_journal = m_checkpoints.Journal;
            m_scatter.Skip(m_checkpoints.PointsTaken);
            for (int a = 0; a < m_journal.Attributes.Length; a++)
                m_scatter.Attributes[a] = m_journal.Attributes[a];
            foreach (var found in m_journal.Statistics)
            {
                var all = m_scatter.Statistics;
                all.Include(found);
                m_scatter.Statistics = all;
            }
            m_provisional = new ProvisionalSample(m_readers, m_attributes, m_grid, m_map, m_plan.ProvisionalPoints);
            m_generations = new BuildGenerations(m_provisional, m_folder, m_grid.Records, m_settings.Sampler, Sizes,
                m_plan.PointsPerChunk, m_settings.SecondsToFirstGeneration, m_slices);
            if (m_files == null)
                return;
            long needed = (m_points - m_scatter.Statistics.Count) * m_grid.Records.StrideBytes, free = m_folder.FreeBytes();
            if (m_journal.At == BuildJournal.Stage.Read && free >= 0 && free < needed)
                throw new PointCloudException(FailureCode.DiskFull, m_target, -1, string.Format(CultureInfo.InvariantCulture,
                    "the disk has too little room: wanted {0} bytes for the points that do not fit into memory, got {1}",
                        needed, free));
        }

        IEnumerator<Work> Distribute()
        {
            bool isReading = m_journal.At == BuildJournal.Stage.Read;
            long sinceCheckpoint = 0;
            for (int i = isReading ? m_journal.Source : m_readers.Count; i < m_readers.Count; i++)
            {
                var reader = m_readers[i];
                var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
                foreach (var attribute in m_attributes)
                    names.Add(attribute.Name);
                var wanted = reader.Info.Schema.Select(names.ToArray());
                int slots = MostSlots(SourceScan.SlotsFor(reader, wanted, m_grid.Records.StrideBytes + sizeof(int),
                    m_plan.ReadBytes));
                m_scatter.BeginSource(reader, m_grid.Sources[i]);
                if (m_journal.Statistics.Count <= i)
                    m_journal.Statistics.Add(PointStatistics.None);
                for (int block = m_journal.Block; block < reader.BlockCount; block = m_journal.Block)
                {
                    int end = block;
                    for (; end < reader.BlockCount && sinceCheckpoint < m_settings.PointsPerCheckpoint; end++)
                        sinceCheckpoint += reader.PointsInBlock(end);
                    using (var scan = new WorkSteps(SourceScan.Run(reader, wanted, m_scatter, slots, block, end, null)))
                    {
                        while (scan.MoveNext())
                        {
                            yield return scan.Current;
                            if (!m_generations.IsFirstDue)
                                continue;
                            yield return Work.Of(m_generations.WriteFirst(m_map.Cube, m_map.Chunks, DescribeSample));
                        }
                    }
                    var found = m_journal.Statistics[i];
                    found.Include(m_scatter.TakeStatistics());
                    m_journal.Statistics[i] = found;
                    m_journal.Block = end;
                    if (sinceCheckpoint < m_settings.PointsPerCheckpoint)
                        continue;
                    sinceCheckpoint = 0;
                    if (m_files == null)
                        continue;
                    yield return Work.Of(m_scatter.WriteAll());
                    // Reading goes on while the disk takes in what was read.
                    yield return Work.Of(m_checkpoints.Begin(m_scatter.Attributes, m_chunks.Chunks));
                }
                m_scatter.EndSource();
                m_journal.Source = i + 1;
                m_journal.Block = 0;
            }
            if (isReading && m_files != null)
                yield return Work.Of(m_scatter.WriteAll());
            CloudDescription.AddSources(m_readers, m_journal.Statistics, m_manifest);
            CloudDescription.Warn(m_readers, m_journal.Statistics, m_grid.Grid);
        }

        /// <summary>The manifest of the sample alone.</summary>
        void DescribeSample(CloudManifest manifest)
        {
            var found = m_provisional.Statistics;
            long last = m_map.Cube.Side - 1;
            // What lies outside the first cube is not in the sample's tops.
            found.Min = Grid3.Max(found.Min, m_map.Cube.Corner);
            found.Max = Grid3.Min(found.Max, m_map.Cube.Corner + new Grid3(last, last, last));
            CloudDescription.Describe(found, m_grid.Grid, m_attributes, m_provisional.Attributes, m_readers[0].Info.Crs, manifest);
            manifest.PointsLeftOut = 0;
            manifest.Sampler = m_manifest.Sampler;
            manifest.CloudId = found.Checksum;
        }

        /// <summary>What lies on disk is what a killed build is continued from, from the end of this work on.</summary>
        IEnumerator<Work> WriteJournal()
        {
            yield return Work.Of(m_checkpoints.Begin(m_scatter.Attributes, m_chunks.Chunks));
            yield return Work.Of(m_checkpoints.End());
        }

        /// <summary>The root cube by what came, and chunks that are neither too large nor needlessly small.</summary>
        IEnumerator<Work> SettleChunks()
        {
            var found = m_scatter.Statistics;
            if (found.Count == 0)
                yield break;
            if (m_journal.At == BuildJournal.Stage.Read)
            {
                var lists = m_scatter.Chunks;
                for (int c = 0; c < m_map.Chunks.Length; c++)
                    TakeChunk(m_map.Chunks[c], lists, c);
                int inside = m_chunks.Chunks.Count;
                TakeChunk(m_map.Cube, lists, m_map.Outside);
                var root = m_map.Cube;
                if (m_chunks.Chunks.Count > inside)
                {
                    var shells = RootCube.Grow(root, found.Min, found.Max);
                    root = shells[shells.Length - 1];
                    yield return Work.Of(m_chunks.SplitOutside(shells, m_chunks.Chunks[inside]));
                }
                m_journal.Root = root;
                m_journal.At = BuildJournal.Stage.Split;
                yield return Work.Of(WriteJournal());
                m_chunks.Settled = WriteJournal;
            }
            else
            {
                foreach (var chunk in m_journal.Chunks)
                    m_chunks.Add(chunk.Cube, chunk.Runs);
                m_chunks.Settled = WriteJournal;
            }
            if (m_journal.At == BuildJournal.Stage.Split)
            {
                yield return Work.Of(m_chunks.SplitLarge(2 * m_plan.PointsPerChunk, m_plan.PointsPerChunk));
                m_journal.Root = RootCube.Shrink(m_journal.Root, found.Min, found.Max);
                m_chunks.MergeSmall(m_journal.Root, m_plan.PointsPerChunk);
                m_journal.At = BuildJournal.Stage.Index;
                yield return Work.Of(WriteJournal());
            }
            m_chunks.Settled = null;
            m_manifest.Root = m_journal.Root;
            if (m_files != null)
                RecordPagePool.Of(m_pool).FreeAll();
        }

        void TakeChunk(GridCube cube, NativeArray<RecordPages> lists, int chunk)
        {
            if (m_files != null)
            {
                m_chunks.Add(cube, chunk);
                return;
            }
            var pages = lists[chunk];
            lists[chunk] = default;
            m_chunks.Add(cube, ref pages);
        }

        IEnumerator<Work> Build()
        {
            var found = m_scatter.Statistics;
            CloudDescription.Describe(found, m_grid.Grid, m_attributes, m_scatter.Attributes, m_readers[0].Info.Crs, m_manifest);
            // Different where content, attributes, partition or sampler differ: enough to tell one build's files from another's.
            m_manifest.CloudId = found.Checksum ^ (ulong)found.Count * 0x9E3779B97F4A7C15UL ^ (ulong)m_plan.PointsPerChunk << 40 ^
                (ulong)m_attributes.Count << 32 ^ (ulong)m_settings.Sampler << 60 ^ (ulong)m_settings.CellsLog2 << 56 ^
                (ulong)m_settings.MaxPointsPerLeaf;

            m_store = new NativeStoreLayout(m_manifest.CreateLayout());
            m_build = new OctreeBuild(m_chunks, m_pool, m_files, m_plan, m_grid.Records, m_store, m_manifest.Root,
                m_manifest.CloudId,
                m_folder, m_settings.Sampler, Sizes, m_generations, m_settings.SecondsPerGeneration, m_slices);
            yield return Work.Of(m_build.Run(MostSlots(JobsUtility.JobWorkerCount + 1), m_manifest, m_progress));
            if (m_build.Checksum != m_manifest.Checksum)
            {
                throw PointCloudException.Wanted(FailureCode.WriteFailed, m_readers[0].Info.Path, -1,
                    "checksum of the points on their way into the octree", m_manifest.Checksum, m_build.Checksum);
            }
        }

        IEnumerator<Work> MeasureShown()
        {
            if (m_manifest.Points == 0)
                yield break;
            using (var folder = CloudFolder.Open(m_folder.PathOf(""), m_manifest))
            using (var selection = new NodeSelection(folder))
            {
                var ranges = new DisplayRanges();
                yield return Work.Of(StoredRanges.Measure(folder, selection,
                    LoadNodes.SchemaFor(folder, ColorModes.AttributesToMeasure(ColorMode.Auto)), UpAxis.Z, ranges));
                m_manifest.Shown = ranges.ToShown();
            }
        }

        ConvertResult Finish()
        {
            var manifest = m_manifest;
            if (m_journal.At == BuildJournal.Stage.Done)
            {
                // Killed between the last file and the name: all that is known of it is on disk.
                string path = m_folder.PathOf(StoreFormat.ManifestName);
                manifest = CloudManifest.FromJson(m_folder.ReadText(StoreFormat.ManifestName) ?? "", path);
            }
            else
            {
                m_folder.WriteText(StoreFormat.ManifestName, manifest.ToJson());
                m_journal.LevelCount = m_build.LevelCount;
                m_journal.BytesOfPlane = m_build.BytesOfPlane;
                m_checkpoints.Finish(m_scatter.Attributes);
            }
            m_folder.Complete();
            var result = new ConvertResult
            {
                Manifest = manifest,
                LevelCount = m_journal.LevelCount,
                BytesOnDisk = m_folder.BytesOnDisk(),
                TemporaryBytesPeak = m_files == null ? 0 : m_files.PeakBytes,
                PointsPerChunk = m_plan.PointsPerChunk,
                Note = m_checkpoints.Note,
                SliceMs = new[] { m_slices.QuantileMs(0.5), m_slices.QuantileMs(0.99), m_slices.QuantileMs(1) },
                BytesOfPlane = m_journal.BytesOfPlane,
                PlaneNames = new string[m_journal.BytesOfPlane.Length],
            };
            var planes = manifest.CreateLayout().Planes;
            for (int p = 0; p < result.PlaneNames.Length; p++)
                result.PlaneNames[p] = planes[p].Name;
            return result;
        }
    }
}
