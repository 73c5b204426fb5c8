using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>Writes a build's journal at the right moments, so that a killed build can be continued from it.</summary>
    /// <remarks>Only a build that keeps its points in files writes it; one in memory starts over, until it has taken
    /// <see cref="ConvertSettings.SecondsInMemory"/>.</remarks>
    internal sealed class BuildCheckpoints : IDisposable
    {
        readonly BuildContext m_build;
        readonly CloudFolderWriter m_folder;
        readonly ScatterPoints m_scatter;
        readonly ChunkSet m_chunks;
        // Leftovers that cannot be resumed.
        bool m_mustClear;
        NativeArray<byte> m_text;
        WriteTicket m_ticket;

        BuildCheckpoints(BuildContext build, ScatterPoints scatter, ChunkSet chunks)
        {
            m_build = build;
            m_folder = build.Folder;
            m_scatter = scatter;
            m_chunks = chunks;
        }

        public BuildJournal Journal { get; private set; }

        /// <summary>What became of an earlier, interrupted build of this target; null if there was none.</summary>
        public string Note { get; private set; }

        /// <summary>Resumes a killed build of the same sources and settings, if its points are
        /// on disk.</summary>
        public static BuildCheckpoints Resume(BuildContext build, ScatterPoints scatter, ChunkSet chunks)
        {
            var checkpoints = new BuildCheckpoints(build, scatter, chunks);
            var folder = build.Folder;
            int partitionFileCount = build.Map.Chunks.Length + 1;
            ulong identity = BuildIdentity.Of(build);
            string text = folder.ReadText(BuildFiles.JournalName);
            var journal = text == null ? null : BuildJournal.FromJson(text);
            bool isSame = journal != null && journal.Identity == identity &&
                journal.Attributes.Length == build.Attributes.Count && (journal.CurrentStage == BuildJournal.Stage.Read
                    ? journal.Source < build.Readers.Count && journal.Statistics.Count == journal.Source + 1 &&
                        journal.RecordCountOfFile.Count == partitionFileCount
                    : journal.Statistics.Count == build.Readers.Count);
            if (isSame)
                build.UseFiles();
            if (isSame && (journal.CurrentStage == BuildJournal.Stage.Done || build.Files.TryResume(journal)))
            {
                checkpoints.Journal = journal;
                scatter.RestoreStatistics(journal);
                checkpoints.Note = string.Format(CultureInfo.InvariantCulture, "continued a build that was broken off: {0} of "
                    + "{1} points were read", scatter.PointsDone, build.Points);
                return checkpoints;
            }
            checkpoints.Journal = new BuildJournal { Identity = identity };
            if (folder.HasLeftovers)
            {
                checkpoints.Note = text == null
                    ? "a build of this target was broken off that had its points in memory: began again"
                    : "a build of this target was broken off that had other sources, settings or versions: began again";
            }
            checkpoints.m_mustClear = folder.HasLeftovers;
            build.AddPartitionFiles();
            return checkpoints;
        }

        /// <summary>Coroutine, once resumed: what must be done before the build goes on.</summary>
        public IEnumerator<JobStep> Prepare()
        {
            if (m_mustClear)
                yield return JobStep.Of(m_build.Folder.Clear());
            if (m_build.Files != null)
                yield return JobStep.Of(m_build.Files.ReadBlocks());
        }

        /// <summary>Coroutine, when nothing waits to be packed: queues the journal after everything that it refers to, so that
        /// this reaches the disk before the journal does. Does nothing if points are in memory.</summary>
        public IEnumerator<JobStep> Begin()
        {
            if (m_build.Files == null)
                yield break;
            yield return JobStep.Of(End());
            m_build.Files.Sync();
            m_text = new NativeArray<byte>(Encoding.UTF8.GetBytes(UpdateJournalText()), Allocator.Persistent);
            m_ticket = m_folder.Write(BuildFiles.JournalName, m_text);
        }

        public IEnumerator<JobStep> End()
        {
            while (m_ticket != null && !m_ticket.IsDone(1))
                yield return default;
            Dispose();
        }

        public IEnumerator<JobStep> Write()
        {
            yield return JobStep.Of(Begin());
            yield return JobStep.Of(End());
        }

        /// <summary>Coroutine: writes the last journal when all files of the cloud are complete, also if points were in
        /// memory: if the folder cannot be renamed, the next build has only that left to do.</summary>
        public IEnumerator<JobStep> Finish(int levelCount, long[] bytesOfPlane)
        {
            Journal.LevelCount = levelCount;
            Journal.BytesOfPlane = bytesOfPlane;
            Journal.CurrentStage = BuildJournal.Stage.Done;
            return m_folder.WriteText(BuildFiles.JournalName, UpdateJournalText());
        }

        public void Dispose()
        {
            m_ticket?.WaitAndStopRetries();
            m_ticket = null;
            if (m_text.IsCreated)
                m_text.Dispose();
            m_text = default;
        }

        string UpdateJournalText()
        {
            Journal.Attributes = m_scatter.Attributes;
            Journal.PeakBytes = m_build.Files?.PeakBytes ?? 0;
            Journal.RecordCountOfFile.Clear();
            Journal.BlockBytesOfFile.Clear();
            for (int file = 0; file < m_build.Files?.FileCount; file++)
            {
                Journal.RecordCountOfFile.Add(m_build.Files.RecordsOf(file));
                Journal.BlockBytesOfFile.Add(m_build.Files.BlocksOf(file).Bytes);
            }
            Journal.Chunks.Clear();
            if (Journal.CurrentStage == BuildJournal.Stage.Split || Journal.CurrentStage == BuildJournal.Stage.Index)
                foreach (var chunk in m_chunks.Chunks)
                    Journal.Chunks.Add(new BuildJournal.Chunk { Cube = chunk.Cube, Ranges = chunk.Ranges.ToArray() });
            return Journal.ToJson();
        }
    }

    internal static class BuildIdentity
    {
        static string VersionOf(string path) => SourcePath.IsRemote(path) ? RemoteFile.Find(path)?.Identity
            : File.Exists(path) ? NumberText.Of(File.GetLastWriteTimeUtc(path).Ticks) : "0";

        /// <summary>Hashes everything that the stored bytes and the temporary files depend on.</summary>
        public static unsafe ulong Of(BuildContext build)
        {
            var map = build.Map;
            var text = new StringBuilder();
            foreach (var reader in build.Readers)
                text.Append(SourcePath.WithoutQuery(SourcePath.Full(reader.Info.Path))).Append('|')
                    .Append(VersionOf(reader.Info.Path)).Append('\n');
            text.Append(build.CloudId).Append('|').Append(build.Plan.MaxPointsPerPlannedCube)
                .Append('|').Append(build.Plan.UsesTemporaryFiles)
                .Append('|').Append(build.RecordLayout.StrideBytes).Append('|').Append(map.Chunks.Length);
            string all = text.ToString();
            fixed (char* first = all)
                return ContentHash.Of(first, all.Length * sizeof(char)) ^
                    ContentHash.Of(map.ChunkOfCell.GetUnsafeReadOnlyPtr(), map.ChunkOfCell.Length * sizeof(int));
        }
    }

    /// <summary>Distinguishes the files of one cloud from another's, and from those of other settings. It is known before the
    /// points are read, and the same wherever the sources lie, for any memory and any number of machines.</summary>
    internal static class CloudIdentity
    {
        /// <summary>Hashes the plan, the settings, and what is known of the sources: name, size, points, the head of the file,
        /// and a sample of the positions. What else is changed in place does not show.</summary>
        public static ulong Of(BuildContext build)
        {
            using var bytes = new MemoryStream();
            using var writer = new BinaryWriter(bytes);
            foreach (var reader in build.Readers)
            {
                writer.Write(reader.FilterHash);
                foreach (var source in CloudDescription.SourcesOf(reader))
                {
                    writer.Write(source.Name);
                    writer.Write(source.FileBytes);
                    writer.Write(source.Points);
                    writer.Write(source.HeadHash);
                }
            }
            writer.Write(build.Map.SampleHash);
            foreach (var attribute in build.Attributes)
                writer.Write(attribute.ToString());
            foreach (var cell in build.Map.BaseCells)
                writer.Write(cell.ToString());
            writer.Write(build.Map.Cube.ToString());
            var (origin, step) = (build.Grid.Grid.Origin, build.Grid.Grid.Step);
            foreach (double value in new[] { origin.x, origin.y, origin.z, step.x, step.y, step.z })
                writer.Write(value);
            var sizes = build.Sizes;
            foreach (long value in new[] { build.Plan.PointsPerChunk, (long)build.Settings.Sampler, sizes.CellsLog2,
                sizes.TargetPointsPerLeaf, NodeSizes.SamplingVersion, StoreFormat.Version })
                writer.Write(value);
            return ContentHash.Of(new ReadOnlySpan<byte>(bytes.GetBuffer(), 0, (int)bytes.Length));
        }
    }
}
