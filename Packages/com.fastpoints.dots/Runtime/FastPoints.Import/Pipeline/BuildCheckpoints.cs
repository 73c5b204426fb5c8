using System.Collections.Generic;
using System.Globalization;
using FastPoints.Base;
using FastPoints.Octree;
using FastPoints.Store;

namespace FastPoints.Pipeline
{
    /// <summary>A build's journal and the moments it is written at: what a killed build is continued from.</summary>
    /// <remarks>Only a build that keeps its points in files writes it; one in memory begins again.</remarks>
    public sealed class BuildCheckpoints
    {
        readonly CloudFolderWriter m_folder;
        readonly RecordFiles m_files;

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
        public static BuildCheckpoints TakeUp(ulong identity, CloudFolderWriter folder, RecordFiles files, int sources,
            int attributes, int firstFiles, long points)
        {
            var checkpoints = new BuildCheckpoints(folder, files);
            string text = folder.ReadText(BuildFiles.JournalName);
            var journal = text == null ? null : BuildJournal.FromJson(text);
            bool isSame = files != null && journal != null && journal.Identity == identity &&
                journal.Attributes.Length == attributes && (journal.At == BuildJournal.Stage.Read
                    ? journal.Source < sources && journal.Findings.Count == journal.Source + 1 &&
                        journal.Records.Count == firstFiles
                    : journal.Findings.Count == sources);
            if (isSame && (journal.At == BuildJournal.Stage.Done || files.TakeOver(journal)))
            {
                checkpoints.Journal = journal;
                foreach (var found in journal.Findings)
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

        /// <summary>Writes the journal: all that it speaks of has been written. Does nothing where points are in memory.</summary>
        /// <param name="attributes">By attribute: what was found so far.</param>
        /// <param name="chunks">As they are now, from <see cref="BuildJournal.Stage.Split"/> on.</param>
        public void Write(AttributeFindings[] attributes, IReadOnlyList<ChunkSet.Chunk> chunks)
        {
            if (m_files == null)
                return;
            Journal.Attributes = attributes;
            Journal.PeakBytes = m_files.PeakBytes;
            Journal.Records.Clear();
            for (int file = 0; file < m_files.FileCount; file++)
                Journal.Records.Add(m_files.RecordsOf(file));
            Journal.Chunks.Clear();
            if (Journal.At != BuildJournal.Stage.Read)
                foreach (var chunk in chunks)
                    Journal.Chunks.Add(new BuildJournal.Chunk { Cube = chunk.Cube, Runs = chunk.Runs.ToArray() });
            m_folder.WriteText(BuildFiles.JournalName, Journal.ToJson());
        }
    }
}
