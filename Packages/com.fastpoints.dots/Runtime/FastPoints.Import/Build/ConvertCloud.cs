using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Las;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Converts files to a stored octree. A sample estimates the density; one pass over the points distributes them over
    /// cubes; large ones are split, small ones joined to chunks; each is turned into nodes; their tops become the upper
    /// levels.</summary>
    public sealed class ConvertCloud : IDisposable
    {
        const int PointsToMeasure = 200_000;

        readonly BuildContext m_build;
        readonly List<SourceSample> m_samples = new List<SourceSample>();
        readonly List<SampleStatistics> m_sampleStatistics = new List<SampleStatistics>();
        BuildCheckpoints m_checkpoints;
        BuildGenerations m_generations;
        ScatterPoints m_scatter;
        ChunkSet m_chunks;
        OctreeBuild m_octree;
        byte[] m_records; // See LasMetadata; null if the sources are not LAS files.

        ConvertCloud(BuildContext build) => m_build = build;

        /// <summary>Coroutine: converts. When the work has ended, the target exists and is complete. If the work was
        /// cancelled or failed, nothing exists except what <see cref="ConvertSettings.KeepUnfinished"/> keeps.</summary>
        /// <param name="readers">The open sources, with the same attributes. They make one cloud.</param>
        /// <param name="target">The folder to make.</param>
        /// <param name="done">Receives the result.</param>
        /// <exception cref="PointCloudException">A source or the target is at fault.</exception>
        public static IEnumerator<JobStep> Run(IReadOnlyList<PointReader> readers, string target, ConvertSettings settings,
            Action<ConvertResult> done, StageProgress progress)
        {
            CloudDescription.Check(readers);
            using var convert = new ConvertCloud(new BuildContext(readers, target, settings, progress));
            progress?.Begin(BuildStages.Sample);
            yield return JobStep.Of(convert.ReadRecords());
            yield return JobStep.Of(convert.Sample());
            yield return JobStep.Of(convert.Partition());
            // The coroutine checks its budget: memory is allocated in steps.
            yield return default;
            yield return JobStep.Of(convert.Resume());
            if (convert.m_checkpoints.Journal.CurrentStage != BuildJournal.Stage.Done)
            {
                progress?.Begin(BuildStages.Read);
                yield return JobStep.Of(new ReadSources(convert.m_build, convert.m_scatter, convert.m_checkpoints,
                    convert.m_generations).Run());
                progress?.Begin(BuildStages.Split);
                yield return JobStep.Of(new RebalanceChunks(convert.m_build, convert.m_scatter, convert.m_chunks,
                    convert.m_checkpoints).Run());
                yield return JobStep.Of(convert.Build());
            }
            progress?.Begin(BuildStages.Finish);
            if (convert.m_octree?.Manifest.Points > 0)
                yield return JobStep.Of(MeasureDisplayRanges(convert.m_build.Folder.PathOf(""), convert.m_octree.Manifest));
            yield return JobStep.Of(convert.Finish(done));
            progress?.End();
        }

        /// <summary>Coroutine: plans what <see cref="Run"/> would build. It reads headers and samples.</summary>
        /// <param name="take">Receives what lasts until it returns, the sample's values by attribute, and what
        /// <see cref="LasMetadata"/> stores, or null.</param>
        internal static IEnumerator<JobStep> Plan(IReadOnlyList<PointReader> readers, ConvertSettings settings,
            Action<BuildContext, AttributeStatistics[], byte[]> take, StageProgress progress)
        {
            CloudDescription.Check(readers);
            using var convert = new ConvertCloud(new BuildContext(readers, null, settings, progress));
            var build = convert.m_build;
            progress?.Begin(BuildStages.Sample);
            yield return JobStep.Of(convert.ReadRecords());
            yield return JobStep.Of(convert.Sample());
            yield return JobStep.Of(convert.Partition());
            using var values = new PlaceholderSample(build);
            yield return JobStep.Of(values.Read());
            take(build, values.StatisticsOfAttributes, convert.m_records);
            progress?.End();
        }

        public void Dispose()
        {
            m_octree?.Dispose();
            m_generations?.Dispose();
            m_chunks?.Dispose();
            m_scatter?.Dispose();
            m_checkpoints?.Dispose();
            foreach (var sample in m_samples)
                sample.Dispose();
            m_samples.Clear();
            m_build.Dispose();
        }

        IEnumerator<JobStep> ReadRecords()
        {
            var paths = CloudDescription.PathsOf(m_build.Readers);
            var losses = new List<Loss>();
            yield return JobStep.Of(PoolTask.Run(paths[0], () => LasMetadata.CommonTo(paths, losses)?.ToBytes(),
                bytes => m_records = bytes));
            m_build.Readers[0].Info.Losses.AddRange(losses);
        }

        IEnumerator<JobStep> Sample()
        {
            using var statistics = new NativeReference<SampleStatistics>(Allocator.Persistent);
            foreach (var reader in m_build.Readers)
            {
                reader.MaxIndexingJobs = m_build.Settings.Workers;
                if (!reader.BlocksAreKnown)
                    yield return JobStep.Of(reader.IndexBlocks());
                yield return JobStep.Of(SourceSample.Read(reader, m_build.InFlightMs, m_build.Settings.Workers,
                    MemoryPlan.ReadBytesOf(m_build.Settings),
                    (stored, loaded) => MeasureSampleJob.Schedule(new MeasureSampleJob
                    {
                        Stored = stored,
                        Statistics = statistics,
                        SliceTimes = m_build.SliceTimes,
                    }, loaded), m_samples.Add));
                m_sampleStatistics.Add(statistics.Value);
            }
        }

        IEnumerator<JobStep> Partition()
        {
            m_build.Choose(m_sampleStatistics);
            var cube = RootCube.Guess(m_build.Readers, m_sampleStatistics, m_build.Grid);
            yield return JobStep.Of(PartitionPlan.Of(cube, m_samples, m_build.Grid, m_build.Plan, m_build.SliceTimes,
                map => m_build.Map = map));
            m_build.CloudId = CloudIdentity.Of(m_build);
            foreach (var sample in m_samples)
                sample.Dispose();
            m_samples.Clear();
        }

        IEnumerator<JobStep> Resume()
        {
            m_scatter = new ScatterPoints(m_build);
            m_chunks = new ChunkSet(m_build);
            m_checkpoints = BuildCheckpoints.Resume(m_build, m_scatter, m_chunks);
            yield return JobStep.Of(m_checkpoints.Prepare());
            m_generations = new BuildGenerations(m_build);
            // What the folder is for, if the build is killed.
            var sources = new List<SourceEntry>();
            foreach (var reader in m_build.Readers)
                sources.AddRange(CloudDescription.SourcesOf(reader));
            yield return JobStep.Of(m_build.Folder.WriteText(StoreFormat.SourcesName, StoredSources.ToJson(sources)));
            if (m_checkpoints.Journal.CurrentStage == BuildJournal.Stage.Read)
                m_build.RequireRoom(m_build.Points - m_scatter.Statistics.Count);
        }

        IEnumerator<JobStep> Build()
        {
            var manifest = CloudDescription.OfBuild(m_build, m_checkpoints.Journal, m_scatter);
            m_octree = new OctreeBuild(m_build, m_chunks, manifest, m_generations);
            yield return JobStep.Of(m_octree.Run());
            if (m_octree.Checksum != manifest.Checksum)
            {
                throw PointCloudException.Wanted(FailureCode.WriteFailed, m_build.Readers[0].Info.Path, -1,
                    "checksum of the points on their way into the octree", manifest.Checksum, m_octree.Checksum);
            }
        }

        internal static IEnumerator<JobStep> MeasureDisplayRanges(string path, CloudManifest manifest)
        {
            using var folder = CloudFolder.Open(path, manifest);
            using var nodes = new CloudSelection(folder);
            var ranges = new DisplayRanges();
            yield return JobStep.Of(MeasureRanges(folder, nodes,
                LoadNodes.SchemaFor(folder, ColorModes.AttributesToMeasure(ColorMode.Auto)), UpAxis.Z, ranges));
            manifest.DisplayRanges = ranges.ToStored();
        }

        /// <summary>Coroutine: measures what a display needs to know of a converted cloud, from the points of its upper
        /// levels.</summary>
        /// <exception cref="PointCloudException">The cloud cannot be read.</exception>
        internal static IEnumerator<JobStep> MeasureRanges(CloudFolder folder, CloudSelection nodes, PointSchema schema,
            UpAxis upAxis, DisplayRanges ranges, Func<PointBatch, IEnumerator<JobStep>> load = null)
        {
            nodes.ChooseEvenly(PointsToMeasure);
            var transform = folder.Manifest.Grid.TransformFromCorner(folder.Manifest.Root.Corner);
            using var batch = new PointBatch(schema, nodes.PointCountOrThrow, Allocator.Persistent);
            yield return JobStep.Of(load != null ? load(batch) : LoadNodes.Run(folder, nodes, batch, null));
            yield return JobStep.Of(ranges.Measure(batch, transform, upAxis));
        }

        IEnumerator<JobStep> Finish(Action<ConvertResult> done)
        {
            var folder = m_build.Folder;
            var journal = m_checkpoints.Journal;
            CloudManifest manifest;
            if (journal.CurrentStage == BuildJournal.Stage.Done)
            {
                // If it is killed between the last file and the name, everything known of it is on disk.
                string path = folder.PathOf(StoreFormat.ManifestName);
                manifest = CloudManifest.FromJson(folder.ReadText(StoreFormat.ManifestName) ?? "", path);
            }
            else
            {
                manifest = m_octree.Manifest;
                if (m_records != null)
                    yield return JobStep.Of(folder.Write(StoreFormat.RecordsName, m_records));
                if (m_build.Readers.Count == 1)
                    yield return JobStep.Of(folder.WriteText(StoreFormat.FactsName, StoredFacts.ToJson(m_build.Readers[0].Info)));
                yield return JobStep.Of(folder.WriteText(StoreFormat.SourcesName, StoredSources.ToJson(
                    CloudDescription.SourcesOf(m_build.Readers, journal.Statistics))));
                yield return JobStep.Of(folder.WriteText(StoreFormat.ManifestName, manifest.ToJson()));
                yield return JobStep.Of(m_checkpoints.Finish(m_octree.LevelCount, m_octree.BytesOfPlane));
            }
            yield return JobStep.Of(folder.Complete());
            var result = new ConvertResult
            {
                Manifest = manifest,
                LevelCount = journal.LevelCount,
                BytesOnDisk = folder.BytesOnDisk,
                TemporaryBytesPeak = m_build.Files == null ? 0 : m_build.Files.PeakBytes,
                PointsPerChunk = m_build.Plan.PointsPerChunk,
                Note = m_checkpoints.Note,
                SliceMs = new[] { m_build.SliceTimes.QuantileMs(0.5), m_build.SliceTimes.QuantileMs(0.99),
                    m_build.SliceTimes.QuantileMs(1) },
                BytesOfPlane = journal.BytesOfPlane,
                PlaneNames = new string[journal.BytesOfPlane.Length],
            };
            var planes = manifest.CreateLayout().Planes;
            for (int p = 0; p < result.PlaneNames.Length; p++)
                result.PlaneNames[p] = planes[p].Name;
            done(result);
        }
    }

    internal sealed class RebalanceChunks
    {
        readonly BuildContext m_build;
        readonly ScatterPoints m_scatter;
        readonly ChunkSet m_chunks;
        readonly BuildCheckpoints m_checkpoints;

        public RebalanceChunks(BuildContext build, ScatterPoints scatter, ChunkSet chunks, BuildCheckpoints checkpoints)
        {
            m_build = build;
            m_scatter = scatter;
            m_chunks = chunks;
            m_checkpoints = checkpoints;
        }

        public IEnumerator<JobStep> Run()
        {
            var journal = m_checkpoints.Journal;
            var found = m_scatter.Statistics;
            if (found.Count == 0)
                yield break;
            if (journal.CurrentStage == BuildJournal.Stage.Read)
            {
                yield return JobStep.Of(AddChunks());
                journal.CurrentStage = BuildJournal.Stage.Split;
                yield return JobStep.Of(m_checkpoints.Write());
            }
            else
            {
                foreach (var chunk in journal.Chunks)
                    m_chunks.Add(chunk.Cube, chunk.Ranges);
            }
            m_chunks.OnRebalanced = m_checkpoints.Write;
            if (journal.CurrentStage == BuildJournal.Stage.Split)
            {
                long target = m_build.Plan.PointsPerChunk;
                var cells = Cells();
                yield return JobStep.Of(m_chunks.SplitLarge(cells, target));
                // The coroutine checks its budget.
                yield return default;
                if (m_build.Part == null || m_build.Part.IsWhole)
                    journal.Root = RootCube.Shrink(journal.Root, found.Min, found.Max);
                m_chunks.MergeSmall(journal.Root, cells, target);
                journal.CurrentStage = BuildJournal.Stage.Index;
                yield return JobStep.Of(m_checkpoints.Write());
            }
            m_chunks.OnRebalanced = null;
            if (m_build.Files != null)
                RecordPagePool.Of(m_build.Pool).FreeAll();
        }

        /// <summary>Adds the partition's chunks. If there are points outside, the root grows until it contains them; a part sets
        /// them aside.</summary>
        IEnumerator<JobStep> AddChunks()
        {
            var map = m_build.Map;
            var lists = m_scatter.Chunks;
            for (int c = 0; c < map.Chunks.Length; c++)
                AddChunk(map.Chunks[c], lists, c);
            int inside = m_chunks.Chunks.Count;
            AddChunk(map.Cube, lists, map.OutsideChunk);
            var cells = Cells();
            m_checkpoints.Journal.Root = cells.Root;
            if (m_build.Part != null)
            {
                m_checkpoints.Journal.Root = m_build.Part.RootOf(m_scatter.Statistics);
                if (m_chunks.Chunks.Count > inside)
                    yield return JobStep.Of(m_chunks.SetAside(m_chunks.Chunks[inside]));
            }
            else if (m_chunks.Chunks.Count > inside)
                yield return JobStep.Of(m_chunks.SplitOutside(cells, m_chunks.Chunks[inside]));
        }

        BaseCells Cells() => new BaseCells(m_build.Map.Cube, m_build.Map.BaseCells, m_build.Part != null ? new GridCube[0]
            : RootCube.Grow(m_build.Map.Cube, m_scatter.Statistics.Min, m_scatter.Statistics.Max));

        void AddChunk(GridCube cube, NativeArray<RecordPages> lists, int chunk)
        {
            if (m_build.Files != null)
            {
                m_chunks.Add(cube, chunk);
                return;
            }
            var pages = lists[chunk];
            lists[chunk] = default;
            m_chunks.Add(cube, ref pages);
        }
    }
}
