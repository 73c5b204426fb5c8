using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Nodes;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>The records that do not fit in memory: one file for each chunk in the target's folder, only appended to, by the
    /// one writer thread, with one file open at a time. Jobs pack their pages first. Written pages can be reused.</summary>
    internal sealed class RecordFiles : IDisposable
    {
        struct PendingWrite
        {
            public int File;
            public JobHandle Packed;
            public WriteTicket Ticket;
            public RecordPages Pages;
        }

        readonly CloudFolderWriter m_folder;
        readonly int m_strideBytes;
        readonly List<RecordBlocks> m_files = new List<RecordBlocks>();
        readonly List<long> m_recordsOfFile = new List<long>();
        readonly List<int> m_usersOfFile = new List<int>();
        readonly SortedSet<int> m_notSynced = new SortedSet<int>();
        readonly Queue<PendingWrite> m_pendingPacks = new Queue<PendingWrite>();
        readonly Queue<PendingWrite> m_pendingWrites = new Queue<PendingWrite>();
        readonly SliceTimes m_slices = new SliceTimes(Allocator.Persistent);
        JobHandle m_lastPacked;
        RecordPages m_written;
        long m_bytes;

        public RecordFiles(CloudFolderWriter folder, int strideBytes)
        {
            m_folder = folder;
            m_strideBytes = strideBytes;
        }

        public long PagesWaiting { get; private set; }

        public long PeakBytes { get; private set; }

        public int FileCount => m_recordsOfFile.Count;

        public RecordBlocks BlocksOf(int file) => m_files[file];

        public string PathOf(int file) => m_files[file].Path;

        public long RecordsOf(int file) => m_recordsOfFile[file];

        public int Add()
        {
            m_files.Add(new RecordBlocks(m_folder.PathOf(BuildFiles.RecordPath(m_files.Count)), 0));
            m_recordsOfFile.Add(0);
            m_usersOfFile.Add(1);
            return m_recordsOfFile.Count - 1;
        }

        /// <summary>Resumes with the files of a killed build, truncated to the lengths in its journal; other files are deleted.
        /// Then <see cref="ReadBlocks"/>.</summary>
        /// <returns>Whether they all exist, except those of chunks that may be done; otherwise none is used.</returns>
        public bool TryResume(BuildJournal journal)
        {
            var users = new int[journal.RecordCountOfFile.Count];
            if (journal.BlockBytesOfFile.Count != users.Length)
                return false;
            bool isReading = journal.CurrentStage == BuildJournal.Stage.Read;
            foreach (var chunk in journal.Chunks)
                foreach (var range in chunk.Ranges)
                    if (range.File < 0 || range.File >= users.Length || range.First < 0 || range.Count < 0 ||
                        range.First > journal.RecordCountOfFile[range.File] - range.Count)
                        return false;
                    else
                        users[range.File]++;
            var known = new HashSet<string>();
            for (int file = 0; file < users.Length; file++)
            {
                long bytes = isReading || users[file] > 0 ? journal.BlockBytesOfFile[file] : 0;
                if (!m_folder.Truncate(BuildFiles.RecordPath(file), bytes) &&
                    journal.CurrentStage != BuildJournal.Stage.Index)
                    return false;
                if (bytes > 0)
                    known.Add(m_folder.PathOf(BuildFiles.RecordPath(file)));
            }
            m_folder.DeleteOthers(BuildFiles.RecordFolderName, known);

            PeakBytes = journal.PeakBytes;
            for (int file = 0; file < users.Length; file++)
            {
                bool isUsed = isReading || users[file] > 0;
                Add();
                m_usersOfFile[file] = isReading ? 1 : users[file];
                m_recordsOfFile[file] = isUsed ? journal.RecordCountOfFile[file] : 0;
                m_files[file] = new RecordBlocks(PathOf(file), isUsed ? journal.BlockBytesOfFile[file] : 0);
                Count(m_files[file].Bytes);
            }
            return true;
        }

        /// <summary>Coroutine: finds the blocks of files that others have written, or a build before this one.</summary>
        /// <exception cref="PointCloudException">They are not what the journal says.</exception>
        public IEnumerator<JobStep> ReadBlocks()
        {
            for (int file = 0; file < m_files.Count; file++)
            {
                var (blocks, records) = (m_files[file], m_recordsOfFile[file]);
                // A chunk that is done has none.
                if (records == 0 || !File.Exists(blocks.Path))
                    continue;
                yield return JobStep.Of(PoolTask.Run(blocks.Path, () => RecordBlocks.Read(blocks.Path, m_strideBytes),
                    read => blocks = read));
                if (blocks.Records != records)
                    throw PointCloudException.Wanted(FailureCode.ReadFailed, blocks.Path, -1, "records that were set aside",
                        records, blocks.Records);
                m_files[file] = blocks;
            }
        }

        /// <summary>Takes over packed records that others have written.</summary>
        public void Adopt(int file, RecordBlocks blocks)
        {
            m_files[file] = blocks;
            m_recordsOfFile[file] = blocks.Records;
            Count(blocks.Bytes);
        }

        public void Append(int file, RecordPages pages)
        {
            if (pages.RecordCount == 0)
                return;
            m_notSynced.Add(file);
            m_recordsOfFile[file] += pages.RecordCount;
            PagesWaiting += pages.PageCount;
            while (pages.PageCount > 0)
            {
                var run = pages.DetachFirst(PackRecordsJob.PagesPerRun);
                m_lastPacked = new PackRecordsJob { Pages = run, StrideBytes = m_strideBytes, SliceTimes = m_slices }
                    .Schedule(m_lastPacked);
                m_pendingPacks.Enqueue(new PendingWrite { File = file, Packed = m_lastPacked, Pages = run });
            }
        }

        /// <summary>Queues a flush: everything that was handed over, and is packed, is on disk before the writer's next
        /// request.</summary>
        public void Sync()
        {
            foreach (int file in m_notSynced)
                m_folder.SyncRecords(BuildFiles.RecordPath(file));
            m_notSynced.Clear();
        }

        /// <summary>Checks what is packed and written by now.</summary>
        /// <exception cref="PointCloudException">Something could not be written.</exception>
        public void Poll(int waitMs)
        {
            // There is nothing else to wait for.
            bool mustPack = waitMs > 0 && m_pendingWrites.Count == 0;
            while (m_pendingPacks.Count > 0 && (mustPack || m_pendingPacks.Peek().Packed.IsCompleted))
            {
                Write(m_pendingPacks.Dequeue());
                mustPack = false;
            }
            while (m_pendingWrites.Count > 0 && m_pendingWrites.Peek().Ticket.IsDone(waitMs))
            {
                var pages = m_pendingWrites.Dequeue().Pages;
                PagesWaiting -= pages.PageCount;
                m_written.Join(ref pages);
                waitMs = 0;
            }
        }

        unsafe void Write(PendingWrite packed)
        {
            packed.Packed.Complete();
            var blocks = m_files[packed.File];
            packed.Ticket = m_folder.WriteRecords(BuildFiles.RecordPath(packed.File), packed.Pages, blocks.Bytes);
            Count(blocks.Add(packed.Pages));
            m_pendingWrites.Enqueue(packed);
        }

        /// <summary>Pages that were written, for the pool.</summary>
        public RecordPages RemoveWritten()
        {
            var pages = m_written;
            m_written = default;
            return pages;
        }

        /// <summary>When no page waits: adds how long packing took.</summary>
        public void AddSliceTimesTo(SliceTimes all)
        {
            m_lastPacked.Complete();
            all.TakeFrom(m_slices);
        }

        public void AddUser(int file) => m_usersOfFile[file]++;

        /// <summary>Ends one user's reading of a file; the last one deletes it.</summary>
        public void Release(int file)
        {
            if (--m_usersOfFile[file] > 0 || m_recordsOfFile[file] == 0)
                return;
            Count(-m_files[file].Bytes);
            m_files[file] = new RecordBlocks(PathOf(file), 0);
            m_recordsOfFile[file] = 0;
            m_notSynced.Remove(file);
            m_folder.Delete(BuildFiles.RecordPath(file));
        }

        public void Dispose()
        {
            m_lastPacked.Complete();
            while (m_pendingWrites.Count > 0)
                m_pendingWrites.Dequeue().Ticket.WaitAndStopRetries();
            m_slices.Dispose();
        }

        void Count(long bytes)
        {
            m_bytes += bytes;
            PeakBytes = Math.Max(PeakBytes, m_bytes);
        }
    }

    internal sealed class RecordBlocks
    {
        readonly List<long> m_firsts = new List<long>();
        readonly List<long> m_offsets = new List<long>();

        /// <param name="bytes">Of blocks that are there, and not known yet.</param>
        public RecordBlocks(string path, long bytes) => (Path, Bytes) = (path, bytes);

        public string Path { get; }
        public long Records { get; private set; }
        public long Bytes { get; private set; }
        public int Count => m_firsts.Count;

        /// <summary>The number of its first record; of the block behind the last, that of all records.</summary>
        public long FirstOf(int block) => block < Count ? m_firsts[block] : Records;

        public long OffsetOf(int block) => block < Count ? m_offsets[block] : Bytes;

        public int Find(long record)
        {
            int found = m_firsts.BinarySearch(record);
            return found >= 0 ? found : ~found - 1;
        }

        public unsafe long Add(in RecordPages packed)
        {
            long before = Bytes;
            var page = packed.First;
            for (int i = 0; i < packed.PageCount; i++, page = page->Next)
                Add(page->Count, page->BlockBytes);
            return Bytes - before;
        }

        /// <summary>Reads the headers of all blocks of a file. Any thread.</summary>
        /// <exception cref="PointCloudException">They do not fill the file.</exception>
        public static RecordBlocks Read(string path, int strideBytes)
        {
            var blocks = new RecordBlocks(path, 0);
            try
            {
                using var file = new BinaryReader(FileChanges.OpenToRead(path, 4096));
                long size = file.BaseStream.Length;
                while (blocks.Bytes < size)
                {
                    file.BaseStream.Position = blocks.Bytes;
                    long records = size - blocks.Bytes < RecordBlock.HeaderBytes ? 0 : file.ReadUInt32();
                    long bytes = records == 0 ? 0 : RecordBlock.HeaderBytes + (long)file.ReadUInt32();
                    // A page has room for as many bytes.
                    if (records == 0 || records > RecordPages.RecordsPerPage || bytes > size - blocks.Bytes ||
                        bytes > RecordBlock.HeaderBytes + records * strideBytes)
                        throw PointCloudException.Wanted(FailureCode.ReadFailed, path, blocks.Bytes, "records of a block",
                            "1 to " + RecordPages.RecordsPerPage + " of " + strideBytes + " bytes", records + " in " + bytes);
                    blocks.Add((int)records, (int)bytes);
                }
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.ReadFailure(path, e);
            }
            return blocks;
        }

        void Add(int records, int bytes)
        {
            m_firsts.Add(Records);
            m_offsets.Add(Bytes);
            Records += records;
            Bytes += bytes;
        }
    }
}
