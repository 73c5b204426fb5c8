using System;
using System.Collections.Generic;
using FastPoints.Nodes;

namespace FastPoints.Build
{
    /// <summary>The records that do not fit in memory: one file for each chunk in the target's folder, only appended to, by the
    /// one writer thread, with one file open at a time. Written pages can be reused.</summary>
    internal sealed class RecordFiles : IDisposable
    {
        struct PendingWrite
        {
            public WriteTicket Ticket;
            public RecordPages Pages;
        }

        readonly CloudFolderWriter m_folder;
        readonly int m_strideBytes;
        readonly List<long> m_recordsOfFile = new List<long>();
        readonly List<int> m_usersOfFile = new List<int>();
        readonly SortedSet<int> m_notSynced = new SortedSet<int>();
        readonly Queue<PendingWrite> m_pendingWrites = new Queue<PendingWrite>();
        RecordPages m_written;
        long m_bytes;

        public RecordFiles(CloudFolderWriter folder, int strideBytes)
        {
            m_folder = folder;
            m_strideBytes = strideBytes;
        }

        public long PagesWaiting { get; private set; }

        /// <summary>Most bytes that the files had at one time.</summary>
        public long PeakBytes { get; private set; }

        public int FileCount => m_recordsOfFile.Count;

        public string PathOf(int file) => m_folder.PathOf(BuildFiles.RecordPath(file));

        public long RecordsOf(int file) => m_recordsOfFile[file];

        /// <summary>Adds an empty file, which does not exist on disk before it has records.</summary>
        public int Add()
        {
            m_recordsOfFile.Add(0);
            m_usersOfFile.Add(1);
            return m_recordsOfFile.Count - 1;
        }

        /// <summary>Resumes with the files of a killed build, truncated to the lengths in its journal; other files are
        /// deleted.</summary>
        /// <returns>Whether they all exist, except those of chunks that may be done; otherwise none is used.</returns>
        public bool TryResume(BuildJournal journal)
        {
            var users = new int[journal.Records.Count];
            bool isReading = journal.CurrentStage == BuildJournal.Stage.Read;
            foreach (var chunk in journal.Chunks)
                foreach (var range in chunk.Ranges)
                    if (range.File < 0 || range.File >= users.Length || range.First < 0 || range.Count < 0 ||
                        range.First > journal.Records[range.File] - range.Count)
                        return false;
                    else
                        users[range.File]++;
            var known = new HashSet<string>();
            for (int file = 0; file < users.Length; file++)
            {
                long records = isReading || users[file] > 0 ? journal.Records[file] : 0;
                if (!m_folder.Truncate(BuildFiles.RecordPath(file), records * m_strideBytes) &&
                    journal.CurrentStage != BuildJournal.Stage.Index)
                    return false;
                if (records > 0)
                    known.Add(PathOf(file));
            }
            m_folder.DeleteOthers(BuildFiles.RecordFolderName, known);

            PeakBytes = journal.PeakBytes;
            for (int file = 0; file < users.Length; file++)
            {
                m_recordsOfFile.Add(isReading || users[file] > 0 ? journal.Records[file] : 0);
                m_usersOfFile.Add(isReading ? 1 : users[file]);
                Count(m_recordsOfFile[file]);
            }
            return true;
        }

        /// <summary>Takes over records that others have written.</summary>
        public void Adopt(int file, long records)
        {
            m_recordsOfFile[file] = records;
            Count(records);
        }

        public void Append(int file, RecordPages pages)
        {
            if (pages.Count == 0)
                return;
            var ticket = m_folder.WriteRecords(BuildFiles.RecordPath(file), pages, m_strideBytes,
                m_recordsOfFile[file] * m_strideBytes);
            m_pendingWrites.Enqueue(new PendingWrite { Ticket = ticket, Pages = pages });
            m_notSynced.Add(file);
            m_recordsOfFile[file] += pages.Count;
            PagesWaiting += pages.PageCount;
            Count(pages.Count);
        }

        /// <summary>Queues a flush: everything handed over is on disk before the writer's next request.</summary>
        public void Sync()
        {
            foreach (int file in m_notSynced)
                m_folder.SyncRecords(BuildFiles.RecordPath(file));
            m_notSynced.Clear();
        }

        /// <summary>Checks what is written by now.</summary>
        /// <exception cref="FastPoints.PointCloudException">Something could not be written.</exception>
        public void Poll(int waitMs)
        {
            while (m_pendingWrites.Count > 0 && m_pendingWrites.Peek().Ticket.IsDone(waitMs))
            {
                var pages = m_pendingWrites.Dequeue().Pages;
                PagesWaiting -= pages.PageCount;
                m_written.Join(ref pages);
                waitMs = 0;
            }
        }

        /// <summary>Pages that were written, for the pool.</summary>
        public RecordPages TakeWritten()
        {
            var pages = m_written;
            m_written = default;
            return pages;
        }

        /// <summary>Adds a user that reads a file and releases it.</summary>
        public void Share(int file) => m_usersOfFile[file]++;

        /// <summary>Ends one user's reading of a file; the last one deletes it.</summary>
        public void Release(int file)
        {
            if (--m_usersOfFile[file] > 0 || m_recordsOfFile[file] == 0)
                return;
            Count(-m_recordsOfFile[file]);
            m_recordsOfFile[file] = 0;
            m_notSynced.Remove(file);
            m_folder.Delete(BuildFiles.RecordPath(file));
        }

        public void Dispose()
        {
            while (m_pendingWrites.Count > 0)
                m_pendingWrites.Dequeue().Ticket.Wait();
        }

        void Count(long records)
        {
            m_bytes += records * m_strideBytes;
            PeakBytes = Math.Max(PeakBytes, m_bytes);
        }
    }
}
