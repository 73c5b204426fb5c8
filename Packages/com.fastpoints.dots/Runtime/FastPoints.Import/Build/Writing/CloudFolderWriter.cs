using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Text;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Writes a cloud's folder under a temporary name, and renames it when it is complete. Each file is complete or
    /// absent: it is written under another name, flushed, then renamed. One thread writes; callers never wait for a
    /// disk.</summary>
    /// <remarks>If disposed before <see cref="Complete"/>, it leaves nothing except what <see cref="Keep"/> keeps. A lock file
    /// keeps out a second build of the same target.</remarks>
    internal sealed unsafe class CloudFolderWriter : IDisposable
    {
        internal const string LockName = "build.lock";

        readonly string m_target;
        readonly string m_unfinished;
        readonly FolderLock m_lock;
        readonly WriteQueue m_queue;
        bool m_isLost;
        bool m_isComplete;
        bool m_isKept;

        /// <param name="target">The final folder: absent, empty, or a cloud that the new one replaces.</param>
        /// <exception cref="PointCloudException">The target is something else, cannot be written, or is being built.</exception>
        public CloudFolderWriter(string target)
        {
            m_target = target.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            m_unfinished = m_target + StoreFormat.UnfinishedSuffix;
            CheckReplaceable(target);
            try
            {
                Directory.CreateDirectory(m_unfinished);
                m_lock = Lock();
                using var entries = Directory.EnumerateFileSystemEntries(m_unfinished).GetEnumerator();
                // One is the lock.
                HasLeftovers = entries.MoveNext() && entries.MoveNext();
                MakeFolders();
            }
            catch (Exception e) when (e is PointCloudException || FileFailures.IsFileFailure(e))
            {
                m_lock?.Dispose();
                throw e as PointCloudException ?? FileFailures.WriteFailure(m_unfinished, e);
            }
            m_queue = new WriteQueue(RenewLock, FolderLock.RenewAfter);
        }

        public bool HasLeftovers { get; } // Whether a build of this target was killed before.

        /// <summary>Reads a text that a killed build left, or returns null if there is none.</summary>
        public string ReadText(string name) => File.Exists(PathOf(name)) ? StoreFile.ReadText(PathOf(name)) : null;

        /// <summary>Coroutine: writes a small file behind everything queued, replacing the one of that name.</summary>
        public IEnumerator<JobStep> WriteText(string name, string text) => Write(name, new UTF8Encoding(false).GetBytes(text));

        public IEnumerator<JobStep> Write(string name, byte[] content)
        {
            using var bytes = new NativeArray<byte>(content, Allocator.Persistent);
            yield return JobStep.Of(Await(Write(name, bytes)));
        }

        /// <summary>Cuts a file to a size; 0 deletes it.</summary>
        /// <returns>Whether it has that size now: false if it was shorter.</returns>
        public bool Truncate(string name, long bytes)
        {
            string path = PathOf(name);
            try
            {
                if (bytes == 0)
                {
                    FileChanges.Delete(path);
                    return true;
                }
                var now = new FileInfo(path);
                if (!now.Exists || now.Length <= bytes)
                    return now.Exists && now.Length == bytes;
                using var file = FileChanges.OpenToWrite(path, FileMode.Open);
                file.SetLength(bytes);
                return true;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.WriteFailure(path, e);
            }
        }

        /// <summary>Deletes files in a folder of the build, before anything that is queued later.</summary>
        /// <param name="kept">Paths to keep, which nobody changes any more.</param>
        public void DeleteOthers(string folder, ICollection<string> kept) => m_queue.Run(PathOf(folder), () =>
        {
            foreach (string file in Directory.GetFiles(PathOf(folder)))
                if (!kept.Contains(PathOf(folder + "/" + Path.GetFileName(file))))
                    FileChanges.Delete(file);
        });

        /// <summary>Coroutine: deletes everything in it, so that the build starts over.</summary>
        public IEnumerator<JobStep> Clear() => Await(m_queue.Run(m_unfinished, () =>
        {
            foreach (string folder in Directory.GetDirectories(m_unfinished))
                FileChanges.DeleteFolder(folder);
            foreach (string file in Directory.GetFiles(m_unfinished))
                if (Path.GetFileName(file) != LockName)
                    FileChanges.Delete(file);
            MakeFolders();
        }));

        /// <summary>Coroutine: work that writes a file, behind everything queued. Who stops it waits for its end.</summary>
        public IEnumerator<JobStep> Run(string name, FileWork work) =>
            Await(m_queue.Run(PathOf(name), () => work(PathOf(name))));

        /// <summary>Queues a file. The bytes belong to the writer until the ticket is done; no job may use them.</summary>
        public WriteTicket Write(string name, NativeArray<byte> bytes) => m_queue.Write(PathOf(name), bytes);

        public WriteTicket WritePiece(string name, NativeArray<byte> bytes, long offset) =>
            m_queue.WritePiece(PathOf(name), bytes, offset);

        public WriteTicket Seal(string name, NativeArray<byte> bytes) => m_queue.Seal(PathOf(name), bytes);

        public WriteTicket WriteRecords(string name, in RecordPages pages, long offset) =>
            m_queue.WriteRecords(PathOf(name), pages, offset);

        /// <summary>Queues a flush of a temporary file: when the ticket is done, everything queued for it before is on disk and
        /// survives a loss of power.</summary>
        public WriteTicket SyncRecords(string name) => m_queue.Sync(PathOf(name));

        public string PathOf(string name) => Path.Combine(m_unfinished, name);

        public void Delete(string name) => m_queue.Run(PathOf(name), () => FileChanges.TryDelete(PathOf(name), () => false));

        public void DeleteGeneration(long generation)
        {
            Delete(StoreFormat.GenerationName(StoreFormat.HierarchyName, generation));
            string folder = PathOf(StoreFormat.UpperFolderName), names = "*" + StoreFormat.PartSuffixOf((int)generation) + ".bin";
            if (generation > 0)
                m_queue.Run(folder, () =>
                {
                    foreach (string file in Directory.GetFiles(folder, names))
                        FileChanges.TryDelete(file, () => false);
                });
        }

        public long BytesOnDisk { get; private set; }

        /// <summary>Free bytes on the target's disk; -1 if unknown.</summary>
        public long FreeBytes() => FreeBytesOf(m_unfinished);

        /// <summary>Free bytes on a folder's disk; -1 if unknown, as on Windows of \\server\share.</summary>
        public static long FreeBytesOf(string folder)
        {
            try
            {
                FileChanges.Intercept?.Invoke(FileChange.Measure, folder, null);
                return new DriveInfo(Path.GetFullPath(folder)).AvailableFreeSpace;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                return -1;
            }
        }

        /// <summary>Coroutine: gives the folder its final name, once streams have released it. Everything must be written,
        /// cloud.json last of all.</summary>
        /// <exception cref="PointCloudException">It cannot be renamed, or now belongs to another writer.</exception>
        public IEnumerator<JobStep> Complete()
        {
            FolderReleases.Release(m_unfinished);
            FolderReleases.Release(m_target);
            try
            {
                for (var watch = Stopwatch.StartNew();
                    !FolderReleases.HasReleased && watch.ElapsedMilliseconds < FileChanges.RetryTimeoutMs;)
                    yield return default;
                yield return JobStep.Of(Await(m_queue.Run(m_target, Finish)));
            }
            finally
            {
                m_queue.End();
                FolderReleases.Reacquire(m_unfinished);
                FolderReleases.Reacquire(m_target);
            }
        }

        public void Keep() => m_isKept = true;

        public void Dispose()
        {
            m_queue.End();
            if (m_isComplete)
                return;
            m_isComplete = true;
            if (!m_isKept && !m_isLost && m_lock.IsHeld)
                Delete(m_unfinished, m_lock);
            else
                m_lock.Dispose();
        }

        /// <summary>Moves away what an unfinished build of a target left, unless it is being built now, and deletes it
        /// on a pool thread.</summary>
        public static void DeleteUnfinished(string target)
        {
            string part =
                target.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar) + StoreFormat.UnfinishedSuffix;
            if (!Directory.Exists(part))
                return;
            try
            {
                if (FolderLock.TakeOrGetOwner(Path.Combine(part, LockName), out var taken) != null)
                    return;
                Delete(part, taken);
            }
            catch (PointCloudException)
            {
                // An unfinished build that cannot be deleted stays.
            }
        }

        /// <summary>The lock goes with the folder. One that cannot be moved is cleared by the next build of the target.</summary>
        static void Delete(string unfinished, FolderLock taken)
        {
            FolderReleases.Release(unfinished);
            FileChanges.BeginDelete(unfinished, failure =>
            {
                FolderReleases.Reacquire(unfinished);
                if (failure != null)
                    taken.Dispose();
            });
        }

        /// <summary>On the writing thread, which may wait.</summary>
        void Finish()
        {
            m_isLost |= !m_lock.IsHeld;
            if (m_isLost)
                throw LockLost();
            string old = m_target + ".old";
            try
            {
                FileChanges.Retry(() => Rename(old), m_queue.ShouldRetry);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                // Only the name is missing: the next build of this target resumes it.
                m_isKept = true;
                if (!Directory.Exists(m_target) && Directory.Exists(old))
                    FileChanges.MoveFolder(old, m_target);
                throw new PointCloudException(FileFailures.WriteFailure(m_target, e).Code, m_target, -1,
                    "is converted but for its name: wanted to rename " + m_unfinished + ", and the system said: " + e.Message +
                    " Close what has files of it open, and convert again, which goes on from here", e);
            }
            m_isComplete = true;
            // The lock was renamed with the folder.
            foreach (string name in new[] { LockName, BuildFiles.JournalName })
                FileChanges.TryDelete(Path.Combine(m_target, name), m_queue.ShouldRetry);
            foreach (string file in Directory.GetFiles(m_target, "*", SearchOption.AllDirectories))
                BytesOnDisk += new FileInfo(file).Length;
            if (Directory.Exists(old))
                FileChanges.BeginDelete(old, _ => { });
        }

        /// <summary>The system may refuse any step while files are read; the rest continues.</summary>
        void Rename(string old)
        {
            FileChanges.DeleteFolder(PathOf(BuildFiles.RecordFolderName));
            FileChanges.DeleteFolder(PathOf(BuildFiles.TopFolderName));
            foreach (string file in Directory.GetFiles(m_unfinished, StoreFormat.HierarchyName.Replace(".bin", "-*.bin")))
                FileChanges.Delete(file);
            foreach (string file in Directory.GetFiles(PathOf(StoreFormat.UpperFolderName), "*.*.bin"))
                FileChanges.Delete(file);
            if (Directory.Exists(m_target))
            {
                FileChanges.DeleteFolder(old);
                FileChanges.MoveFolder(m_target, old);
            }
            FileChanges.MoveFolder(m_unfinished, m_target);
        }

        void MakeFolders()
        {
            Directory.CreateDirectory(PathOf(StoreFormat.ChunkFolderName));
            Directory.CreateDirectory(PathOf(StoreFormat.UpperFolderName));
            Directory.CreateDirectory(PathOf(BuildFiles.RecordFolderName));
            Directory.CreateDirectory(PathOf(BuildFiles.TopFolderName));
        }

        /// <summary>Coroutine; also where it is cancelled, the bytes are free at its end.</summary>
        public static IEnumerator<JobStep> Await(WriteTicket ticket)
        {
            try
            {
                while (!ticket.IsDone(1))
                    yield return default;
            }
            finally
            {
                ticket.WaitAndStopRetries();
            }
        }

        void CheckReplaceable(string target)
        {
            if (File.Exists(m_target))
                throw new PointCloudException(FailureCode.WriteFailed, target, -1, "is a file, wanted a folder to be made");
            if (!Directory.Exists(m_target) || File.Exists(Path.Combine(m_target, StoreFormat.ManifestName)))
                return;
            using var entries = Directory.EnumerateFileSystemEntries(m_target).GetEnumerator();
            if (entries.MoveNext())
                throw new PointCloudException(FailureCode.WriteFailed, target, -1,
                    "is a folder with other things in it: wanted none, or a cloud to replace");
        }

        FolderLock Lock()
        {
            string owner = FolderLock.TakeOrGetOwner(PathOf(LockName), out var taken);
            return taken ?? throw new PointCloudException(FailureCode.WriteFailed, m_target, -1, "is being built by " + owner);
        }

        /// <summary>Renews the lock on the writing thread.</summary>
        /// <returns>Why nothing may be written any more; null if the folder still belongs to this writer.</returns>
        PointCloudException RenewLock()
        {
            m_isLost |= !m_lock.Renew(DateTime.UtcNow);
            return m_isLost ? LockLost() : null;
        }

        /// <summary>The failure when, after a long sleep of the machine, another writer has taken the folder over.</summary>
        PointCloudException LockLost() =>
            new PointCloudException(FailureCode.WriteFailed, m_target, -1, "was taken over by another process");
    }

    /// <summary>Names of files that exist only in an unfinished folder.</summary>
    internal static class BuildFiles
    {
        public const string JournalName = "build.json";

        /// <summary>The folder of points that are not in their nodes yet, packed: see <see cref="RecordBlock"/>.</summary>
        public const string RecordFolderName = "records";
        public const string TopFolderName = "tops"; // Chunks' top nodes, which the merge of the upper levels consumes.
        public const string OutsideName = "part.outside"; // Of a part: points outside of the cloud's planned cube, packed.

        public static string RecordPath(int number) => PathOf(RecordFolderName, number);

        public static string TopPath(int number) => PathOf(TopFolderName, number);

        static string PathOf(string folder, int number) =>
            folder + "/" + number.ToString("D6", CultureInfo.InvariantCulture) + ".bin";
    }

    /// <summary>Work with one file, on the thread that writes; it may be done again.</summary>
    internal delegate void FileWork(string path);
}
