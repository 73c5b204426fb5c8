using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using FastPoints.Base;
using FastPoints.Partition;
using FastPoints.Writing;
using Unity.Collections;

namespace FastPoints.Convert
{
    /// <summary>A build's journal and the moments it is written at: what a killed build is continued from.</summary>
    /// <remarks>Only a build that keeps its points in files writes it; one in memory begins again.</remarks>
    internal sealed class BuildCheckpoints : IDisposable
    {
        readonly CloudFolderWriter m_folder;
        readonly RecordFiles m_files;
        NativeArray<byte> m_text;
        WriteTicket m_ticket;

        BuildCheckpoints(CloudFolderWriter folder, RecordFiles files)
        {
            m_folder = folder;
            m_files = files;
        }

        public BuildJournal Journal { get; private set; }

        /// <summary>What became of a build of this target that was broken off; null where there was none.</summary>
        public string Note { get; private set; }

        /// <summary>Points that the build before this one has read.</summary>
        public long PointsTaken { get; private set; }

        /// <summary>Takes up the build that was killed, where there is one of the same sources and settings, and its points are
        /// on disk. Otherwise the folder is emptied.</summary>
        /// <param name="identity">Of this build.</param>
        /// <param name="files">Of the points; null where they stay in memory. It has the journal's files afterwards, or new
        /// ones.</param>
        /// <param name="sources">Readers of this build.</param>
        /// <param name="attributes">Attributes beside the position.</param>
        /// <param name="firstFiles">Files that the first partition needs.</param>
        /// <param name="points">Of all sources, to tell how much was done.</param>
        public static BuildCheckpoints Resume(ulong identity, CloudFolderWriter folder, RecordFiles files, int sources,
            int attributes, int firstFiles, long points)
        {
            var checkpoints = new BuildCheckpoints(folder, files);
            string text = folder.ReadText(BuildFiles.JournalName);
            var journal = text == null ? null : BuildJournal.FromJson(text);
            bool isSame = files != null && journal != null && journal.Identity == identity &&
                journal.Attributes.Length == attributes && (journal.At == BuildJournal.Stage.Read
                    ? journal.Source < sources && journal.Statistics.Count == journal.Source + 1 &&
                        journal.Records.Count == firstFiles
                    : journal.Statistics.Count == sources);
            if (isSame && (journal.At == BuildJournal.Stage.Done || files.TakeOver(journal)))
            {
                checkpoints.Journal = journal;
                foreach (var found in journal.Statistics)
                    checkpoints.PointsTaken += found.Count + found.LeftOut;
                checkpoints.Note = string.Format(CultureInfo.InvariantCulture, "continued a build that was broken off: {0} of "
                    + "{1} points were read", checkpoints.PointsTaken, points);
                return checkpoints;
            }
            checkpoints.Journal = new BuildJournal { Identity = identity };
            if (folder.HasLeftovers)
            {
                checkpoints.Note = text == null
                    ? "a build of this target was broken off that had its points in memory: began again"
                    : "a build of this target was broken off that had other sources, settings or versions: began again";
            }
            folder.Clear();
            while (files != null && files.FileCount < firstFiles)
                files.Add();
            return checkpoints;
        }

        /// <summary>Work for a pump: queues the journal behind all that it speaks of, which is on the disk itself before the
        /// journal is. Does nothing where points are in memory.</summary>
        /// <param name="attributes">By attribute: what was found so far.</param>
        /// <param name="chunks">As they are now, from <see cref="BuildJournal.Stage.Split"/> on.</param>
        public IEnumerator<Work> Begin(AttributeStatistics[] attributes, IReadOnlyList<ChunkSet.Chunk> chunks)
        {
            if (m_files == null)
                yield break;
            yield return Work.Of(End());
            m_files.Sync();
            m_text = new NativeArray<byte>(Encoding.UTF8.GetBytes(Describe(attributes, chunks)), Allocator.Persistent);
            m_ticket = m_folder.Write(BuildFiles.JournalName, m_text);
        }

        /// <summary>Work for a pump: until the last journal is on the disk.</summary>
        public IEnumerator<Work> End()
        {
            while (m_ticket != null && !m_ticket.IsDone(1))
                yield return default;
            Dispose();
        }

        /// <summary>Writes the last journal there is: all files of the cloud are whole.</summary>
        public void Finish(AttributeStatistics[] attributes)
        {
            Journal.At = BuildJournal.Stage.Done;
            if (m_files != null)
                m_folder.WriteText(BuildFiles.JournalName, Describe(attributes, new ChunkSet.Chunk[0]));
        }

        public void Dispose()
        {
            m_ticket?.Wait();
            m_ticket = null;
            if (m_text.IsCreated)
                m_text.Dispose();
            m_text = default;
        }

        string Describe(AttributeStatistics[] attributes, IReadOnlyList<ChunkSet.Chunk> chunks)
        {
            Journal.Attributes = attributes;
            Journal.PeakBytes = m_files.PeakBytes;
            Journal.Records.Clear();
            for (int file = 0; file < m_files.FileCount; file++)
                Journal.Records.Add(m_files.RecordsOf(file));
            Journal.Chunks.Clear();
            if (Journal.At != BuildJournal.Stage.Read)
                foreach (var chunk in chunks)
                    Journal.Chunks.Add(new BuildJournal.Chunk { Cube = chunk.Cube, Runs = chunk.Runs.ToArray() });
            return Journal.ToJson();
        }
    }
}
