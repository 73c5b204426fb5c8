using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Nodes;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>For sources whose points are anywhere: writes the points of some blocks as plain records, those of each part
    /// together, so that parts read these and no source.</summary>
    internal sealed class BucketBuild : IDisposable
    {
        readonly BuildContext m_build;
        readonly PartSelection m_selection;
        ScatterPoints m_scatter;
        ChunkSet m_chunks;
        BuildCheckpoints m_checkpoints;
        BuildGenerations m_generations;

        BucketBuild(BuildContext build, PartSelection selection)
        {
            m_build = build;
            m_selection = selection;
            build.TakePointsWanted = selection.TakePointsWanted;
            build.Settings.SecondsPerGeneration = build.Settings.SecondsToFirstGeneration = double.PositiveInfinity;
        }

        /// <summary>Coroutine. The folder then has the records, <see cref="BuildFiles.BucketName"/>, and what is known of
        /// them.</summary>
        /// <param name="whole">All of the cloud.</param>
        /// <param name="cubes">Of the parts, which fill its cube, in Morton order.</param>
        /// <param name="blocks">Ascending. The reader's blocks are known.</param>
        /// <param name="ranges">Receives where the records of each part are; those outside of all have the number behind the
        /// last.</param>
        /// <exception cref="PointCloudException">A source or the folder is at fault, or a value contradicts the plan.</exception>
        public static IEnumerator<JobStep> Run(BuildPart whole, GridCube[] cubes, PointReader reader, IReadOnlyList<int> blocks,
            List<BucketRange> ranges, PartOutput output)
        {
            var isOwn = new bool[blocks.Count];
            Array.Fill(isOwn, true);
            var selection = new PartSelection(whole, GridChoice.OnGrid(reader.Info, whole.Grid), isOwn);
            using var bucket = new BucketBuild(new BuildContext(whole, new[] { new FilteredReader(reader, selection, blocks) }, 0,
                output.Folder, output.Settings, output.Progress), selection);
            var build = bucket.m_build;
            build.Progress?.Begin(BuildStages.Read);
            build.Map = PartitionMap.Of(whole.Whole, cubes);
            build.Map.BaseCells = whole.BaseCells;
            yield return JobStep.Of(bucket.Read());
            whole.RequireDivisors(bucket.m_scatter.Attributes, reader.Info.Path);
            yield return JobStep.Of(bucket.Write(ranges, output.Take));
            build.Progress?.End();
        }

        public void Dispose()
        {
            m_generations?.Dispose();
            m_chunks?.Dispose();
            m_scatter?.Dispose();
            m_checkpoints?.Dispose();
            m_build.Dispose();
            m_selection.Dispose();
        }

        IEnumerator<JobStep> Read()
        {
            m_scatter = new ScatterPoints(m_build);
            m_chunks = new ChunkSet(m_build);
            m_checkpoints = BuildCheckpoints.Resume(m_build, m_scatter, m_chunks);
            if (m_checkpoints.MustClear)
                yield return JobStep.Of(m_build.Folder.Clear());
            m_generations = new BuildGenerations(m_build);
            m_build.RequireRoom(2 * m_build.Points - m_scatter.Statistics.Count);
            yield return JobStep.Of(new ReadSources(m_build, m_scatter, m_checkpoints, m_generations).Run());
        }

        IEnumerator<JobStep> WriteRecords(List<BucketRange> ranges)
        {
            var chunks = m_scatter.Chunks;
            int stride = m_build.Records.StrideBytes;
            foreach (var range in ranges)
                yield return JobStep.Of(CloudFolderWriter.Await(m_build.Folder.WriteRecords(BuildFiles.BucketName,
                    chunks[range.Part], stride, range.First * stride)));
            yield return JobStep.Of(CloudFolderWriter.Await(m_build.Folder.SyncRecords(BuildFiles.BucketName)));
        }

        IEnumerator<JobStep> JoinFiles(List<BucketRange> ranges)
        {
            var files = m_build.Files;
            string path = m_build.Folder.PathOf(BuildFiles.BucketName);
            return PoolTask.Run(path, () =>
            {
                using var to = FileChanges.OpenToWrite(path, FileMode.Create);
                foreach (var range in ranges)
                    using (var from = FileChanges.OpenToRead(files.PathOf(range.Part), 1 << 16))
                        from.CopyTo(to, 1 << 20);
                to.Flush(true);
                return true;
            }, _ => { });
        }

        IEnumerator<JobStep> Write(List<BucketRange> ranges, Action<PartResult> take)
        {
            long first = 0;
            for (int part = 0; part <= m_build.Map.Outside; part++)
            {
                long count = m_build.Files?.RecordsOf(part) ?? m_scatter.Chunks[part].Count;
                if (count > 0)
                    ranges.Add(new BucketRange { Part = part, First = first, Count = count });
                first += count;
            }
            yield return JobStep.Of(m_build.Files == null ? WriteRecords(ranges) : JoinFiles(ranges));
            var manifest = m_build.Part.ToManifest(m_build.Settings.Sampler);
            using var store = new NativeStoreLayout(manifest.CreateLayout());
            using var merge = new UpperMerge(m_build, store, manifest);
            var result = new PartResult(m_build.Attributes.Count, merge.BytesOfPlane.Length)
            {
                Statistics = m_scatter.Statistics,
                Attributes = m_scatter.Attributes,
                PointsWanted = m_checkpoints.Journal.PointsWanted,
                OutsidePoints = ranges.Count > 0 && ranges[ranges.Count - 1].Part == m_build.Map.Outside
                    ? ranges[ranges.Count - 1].Count : 0,
            };
            yield return JobStep.Of(PartFile.Write(m_build.Folder, m_build.Part.Cube, m_build.CloudId, merge, result));
            yield return JobStep.Of(m_build.Folder.Complete());
            take(result);
        }
    }

    /// <summary>Records of a bucket that belong to one part.</summary>
    internal struct BucketRange
    {
        public int Part;
        public long First;
        public long Count;
    }
}
