using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>One of several builds that make a cloud: the chunks of its cube, and the upper levels as far as its points decide
    /// them. The bytes are those that one build of everything would write.</summary>
    internal sealed class PartBuild : IDisposable
    {
        readonly BuildContext m_build;
        readonly PartSelection m_selection;
        Action<string> m_fetch;
        ScatterPoints m_scatter;
        ChunkSet m_chunks;
        BuildCheckpoints m_checkpoints;
        BuildGenerations m_generations;
        OctreeBuild m_octree;

        PartBuild(BuildContext build, PartSelection selection)
        {
            m_build = build;
            m_selection = selection;
            if (selection != null)
                build.TakePointsWanted = selection.TakePointsWanted;
            // A part of a cloud is none.
            build.Settings.SecondsPerGeneration = build.Settings.SecondsToFirstGeneration = double.PositiveInfinity;
        }

        /// <summary>Coroutine: from sources. When it has ended, the folder has containers and the part's files.</summary>
        /// <param name="blocks">Those that may have points of the part, ascending. The reader's blocks are known.</param>
        /// <param name="isOwn">By entry of these: see <see cref="PartSelection"/>.</param>
        /// <exception cref="PointCloudException">A source or the folder is at fault, or a value contradicts the plan.</exception>
        public static IEnumerator<JobStep> Run(BuildPart part, PointReader reader, IReadOnlyList<int> blocks,
            IReadOnlyList<bool> isOwn, PartOutput output)
        {
            var selection = new PartSelection(part, GridChoice.OnGrid(reader.Info, part.Grid), isOwn);
            var selected = new FilteredReader(reader, selection, blocks);
            return Run(new PartBuild(new BuildContext(part, new[] { selected }, 0, output.Folder, output.Settings,
                output.Progress), selection), output.Take);
        }

        /// <summary>Coroutine: from plain records in a file.</summary>
        /// <param name="records">Number of records.</param>
        /// <param name="fetch">Writes the file, on a pool thread.</param>
        public static IEnumerator<JobStep> RunRecords(BuildPart part, long records, Action<string> fetch, PartOutput output) =>
            Run(new PartBuild(new BuildContext(part, Array.Empty<PointReader>(), records, output.Folder, output.Settings,
                output.Progress), null) { m_fetch = fetch }, output.Take);

        static IEnumerator<JobStep> Run(PartBuild part, Action<PartResult> take)
        {
            using (part)
            {
                var build = part.m_build;
                build.Progress?.Begin(BuildStages.Sample);
                yield return JobStep.Of(part.Partition());
                // The coroutine checks its budget.
                yield return default;
                part.m_scatter = new ScatterPoints(build);
                part.m_chunks = new ChunkSet(build);
                part.m_checkpoints = BuildCheckpoints.Resume(build, part.m_scatter, part.m_chunks);
                if (part.m_checkpoints.MustClear)
                    yield return JobStep.Of(build.Folder.Clear());
                part.m_generations = new BuildGenerations(build);
                build.Progress?.Begin(BuildStages.Read);
                if (part.m_checkpoints.Journal.CurrentStage == BuildJournal.Stage.Read)
                    yield return JobStep.Of(part.Read());
                build.Progress?.Begin(BuildStages.Split);
                yield return JobStep.Of(new RebalanceChunks(build, part.m_scatter, part.m_chunks, part.m_checkpoints).Run());
                build.Part.RequireDivisors(part.m_scatter.Attributes, build.Target);
                yield return JobStep.Of(part.WriteNodes(take));
                build.Progress?.End();
            }
        }

        public void Dispose()
        {
            m_octree?.Dispose();
            m_generations?.Dispose();
            m_chunks?.Dispose();
            m_scatter?.Dispose();
            m_checkpoints?.Dispose();
            m_build.Dispose();
            m_selection?.Dispose();
        }

        IEnumerator<JobStep> Partition()
        {
            var part = m_build.Part;
            var samples = new List<SourceSample>();
            try
            {
                foreach (var reader in m_build.Readers)
                    yield return JobStep.Of(SourceSample.Read(reader, m_build.InFlightMs, m_build.Settings.Workers,
                        MemoryPlan.ReadBytesOf(m_build.Settings), (_, loaded) => loaded, samples.Add));
                if (samples.Count == 0)
                    m_build.Map = PartitionMap.Of(part.Cube, new[] { part.Cube });
                else
                    yield return JobStep.Of(PartitionPlan.Of(part.Cube, samples, m_build.Grid, m_build.Plan, m_build.Slices,
                        map => m_build.Map = map));
                m_build.Map.BaseCells = part.BaseCells;
                // What the sample does not count.
                m_selection?.TakePointsWanted();
            }
            finally
            {
                foreach (var sample in samples)
                    sample.Dispose();
            }
        }

        IEnumerator<JobStep> Read()
        {
            if (m_fetch == null)
            {
                m_build.RequireRoom(m_build.Points - m_scatter.Statistics.Count);
                yield return JobStep.Of(new ReadSources(m_build, m_scatter, m_checkpoints, m_generations).Run());
                yield break;
            }
            // In memory they are in a file, too, until they are loaded.
            m_build.RequireRoom(m_build.Points);
            string path = m_build.Folder.PathOf(BuildFiles.RecordPath(0));
            long wanted = m_build.Points * m_build.Records.StrideBytes;
            yield return JobStep.Of(PoolTask.Run(path, () =>
            {
                m_fetch(path);
                return StoreFile.SizeOf(path);
            }, bytes =>
            {
                if (bytes != wanted)
                    throw PointCloudException.Wanted(FailureCode.ReadFailed, path, -1, "bytes of the part's points", wanted, bytes);
            }));
            if (m_build.Files != null)
                m_build.Files.Adopt(0, m_build.Points);
            else
                yield return JobStep.Of(Load(path));
            var cube = m_build.Part.Cube;
            m_checkpoints.Journal.Statistics.Add(new PointStatistics
            {
                Count = m_build.Points,
                Min = cube.Corner,
                Max = cube.Corner + new Grid3(cube.Side - 1, cube.Side - 1, cube.Side - 1),
            });
            m_scatter.Resume(m_checkpoints.Journal);
        }

        IEnumerator<JobStep> Load(string path)
        {
            using var load = new RecordLoad(m_build);
            using var outside = new NativeReference<int>(Allocator.Persistent);
            var ranges = new[] { new RecordRange { Count = m_build.Points } };
            var chunks = m_scatter.Chunks;
            for (long first = 0, count; first < m_build.Points; first += count)
            {
                count = Math.Min(ChunkSet.PagesPerBatch * RecordPages.RecordsPerPage, m_build.Points - first);
                load.Begin(ranges, first, count, path);
                yield return load.Done;
                var pages = load.Complete();
                var checkedRecords = CheckRecordsJob.Schedule(new CheckRecordsJob
                {
                    Slices = m_build.Slices,
                    Pages = pages,
                    Layout = m_build.Records,
                    Cube = m_build.Part.Cube,
                    Outside = outside,
                }, default);
                yield return checkedRecords;
                checkedRecords.Complete();
                var all = chunks[0];
                all.Join(ref pages);
                chunks[0] = all;
            }
            if (outside.Value > 0)
                throw PointCloudException.Wanted(FailureCode.ReadFailed, path, -1, "points outside of the part", 0, outside.Value);
            m_build.Folder.Delete(BuildFiles.RecordPath(0));
        }

        IEnumerator<JobStep> WriteNodes(Action<PartResult> take)
        {
            var part = m_build.Part;
            var manifest = part.ToManifest(m_build.Settings.Sampler);
            m_octree = new OctreeBuild(m_build, m_chunks, manifest, m_generations);
            yield return JobStep.Of(m_octree.Index());
            m_build.Progress?.Begin(BuildStages.Merge);
            using var store = new NativeStoreLayout(manifest.CreateLayout());
            using var merge = new UpperMerge(m_build, store, manifest);
            for (int c = 0; c < m_octree.Results.Count; c++)
                merge.Add(m_octree.Results[c], m_octree.TopRecords[c]);
            // Tops of points outside of the whole cube meet all others in the last merge.
            if (part.Whole.Contains(part.Cube))
                yield return JobStep.Of(merge.Collect(part.Cube, m_build.Progress));
            var result = new PartResult(part.Attributes.Count, m_octree.BytesOfPlane.Length)
            {
                // Of records the bucket has them.
                Statistics = m_fetch == null ? m_scatter.Statistics : PointStatistics.None,
                Attributes = m_scatter.Attributes,
                PointsWanted = m_checkpoints.Journal.PointsWanted,
                Checksum = m_octree.Checksum,
            };
            result.Include(m_octree.LowestSideLog2, m_octree.BytesOfPlane);
            result.Include(merge.LowestSideLog2, merge.BytesOfPlane);
            string outside = m_build.Folder.PathOf(BuildFiles.OutsideName);
            if (System.IO.File.Exists(outside))
                result.OutsidePoints = StoreFile.SizeOf(outside) / m_build.Records.StrideBytes;
            yield return JobStep.Of(PartFile.Write(m_build.Folder, part.Cube, part.CloudId, merge, result));
            yield return JobStep.Of(m_build.Folder.Complete());
            take(result);
        }
    }

    /// <summary>Where a task of a build of many goes.</summary>
    internal struct PartOutput
    {
        /// <summary>A folder of its own, which exists when the work has ended.</summary>
        public string Folder;
        public ConvertSettings Settings;
        public Action<PartResult> Take;
        public StageProgress Progress;
    }
}
