using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Records;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Writing
{
    /// <summary>Writes a cloud's folder under a temporary name, and renames it when it is complete. Each file is complete or
    /// absent: it is written under another name, flushed, then renamed. One thread writes; callers never wait for a
    /// disk.</summary>
    /// <remarks>If disposed before <see cref="Complete"/>, it leaves nothing except what <see cref="Keep"/> keeps. A lock file
    /// keeps out a second build of the same target.</remarks>
    internal sealed unsafe class CloudFolderWriter : IDisposable
    {
        const string LockName = "build.lock";

        readonly string m_target;
        readonly string m_part;
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
            m_part = m_target + StoreFormat.PartSuffix;
            CheckReplaceable(target);
            try
            {
                Directory.CreateDirectory(m_part);
                m_lock = Lock();
                HasLeftovers = Directory.GetFileSystemEntries(m_part).Length > 1;
                if (!File.Exists(PathOf(BuildFiles.JournalName)))
                    Clear();
            }
            catch (Exception e) when (e is PointCloudException || FileFailures.IsFileFailure(e))
            {
                m_lock?.Dispose();
                throw e as PointCloudException ?? FileFailures.Writing(m_part, e);
            }
            m_queue = new WriteQueue(RenewLock, FolderLock.RenewAfter);
        }

        /// <summary>Whether a build of this target was killed before.</summary>
        public bool HasLeftovers { get; }

        /// <summary>Reads a text that a killed build left, or returns null if there is none.</summary>
        public string ReadText(string name) => File.Exists(PathOf(name)) ? StoreFile.ReadText(PathOf(name)) : null;

        /// <summary>Writes a small file on the calling thread, replacing the one of that name.</summary>
        public void WriteText(string name, string text)
        {
            try
            {
                byte[] bytes = new UTF8Encoding(false).GetBytes(text);
                fixed (byte* first = bytes)
                    WriteQueue.WriteFile(PathOf(name), first, bytes.Length);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(PathOf(name), e);
            }
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
                    File.Delete(path);
                    return true;
                }
                if (!File.Exists(path))
                    return false;
                using var file = new FileStream(path, FileMode.Open, FileAccess.Write);
                if (file.Length < bytes)
                    return false;
                file.SetLength(bytes);
                return true;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }

        /// <summary>Deletes files in a folder of the build.</summary>
        /// <param name="kept">Paths to keep.</param>
        public void DeleteOthers(string folder, ICollection<string> kept)
        {
            try
            {
                foreach (string file in Directory.GetFiles(PathOf(folder)))
                    if (!kept.Contains(PathOf(folder + "/" + Path.GetFileName(file))))
                        File.Delete(file);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(PathOf(folder), e);
            }
        }

        /// <summary>Deletes everything in it: the build starts over.</summary>
        public void Clear()
        {
            try
            {
                foreach (string folder in Directory.GetDirectories(m_part))
                    Directory.Delete(folder, true);
                foreach (string file in Directory.GetFiles(m_part))
                    if (Path.GetFileName(file) != LockName)
                        File.Delete(file);
                Directory.CreateDirectory(PathOf(StoreFormat.ChunkFolderName));
                Directory.CreateDirectory(PathOf(BuildFiles.RecordFolderName));
                Directory.CreateDirectory(PathOf(BuildFiles.TopFolderName));
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(m_part, e);
            }
        }

        /// <summary>Queues a file. The bytes belong to the writer until the ticket is done; no job may use them.</summary>
        public WriteTicket Write(string name, NativeArray<byte> bytes) => m_queue.Write(PathOf(name), bytes);

        /// <summary>Queues a piece of a file, which exists when <see cref="Seal"/> is done with it. The bytes belong to the
        /// writer until the ticket is done.</summary>
        /// <param name="offset">Offset of the piece in the file.</param>
        public WriteTicket WritePiece(string name, NativeArray<byte> bytes, long offset) =>
            m_queue.WritePiece(PathOf(name), bytes, offset);

        /// <summary>Queues the first bytes of a file in pieces, which complete it.</summary>
        public WriteTicket Seal(string name, NativeArray<byte> bytes) => m_queue.Seal(PathOf(name), bytes);

        /// <summary>Queues records for a temporary file. The pages belong to the writer until the ticket is done.</summary>
        /// <param name="offset">The file's size so far.</param>
        public WriteTicket WriteRecords(string name, in RecordPages pages, int strideBytes, long offset) =>
            m_queue.WriteRecords(PathOf(name), pages, strideBytes, offset);

        /// <summary>Queues a flush of a temporary file: when the ticket is done, everything queued for it before is on disk and
        /// survives a loss of power.</summary>
        public WriteTicket SyncRecords(string name) => m_queue.Sync(PathOf(name));

        /// <summary>Path of a file of the folder while it is in the making.</summary>
        public string PathOf(string name) => Path.Combine(m_part, name);

        /// <summary>Deletes a file that the build no longer needs, for which nothing is queued.</summary>
        public void Delete(string name)
        {
            string path = PathOf(name);
            try
            {
                File.Delete(path);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }

        /// <summary>Deletes the files of one generation of the cloud in the making, if they exist.</summary>
        public void DeleteGeneration(long generation)
        {
            Delete(StoreFormat.GenerationName(StoreFormat.UpperName, generation));
            Delete(StoreFormat.GenerationName(StoreFormat.HierarchyName, generation));
        }

        /// <summary>Bytes of the cloud when it is complete.</summary>
        public long BytesOnDisk()
        {
            long bytes = 0;
            foreach (string file in Directory.GetFiles(m_target, "*", SearchOption.AllDirectories))
                bytes += new FileInfo(file).Length;
            return bytes;
        }

        /// <summary>Free bytes on the target's disk; -1 if unknown.</summary>
        public long FreeBytes()
        {
            try
            {
                return new DriveInfo(Path.GetFullPath(m_part)).AvailableFreeSpace;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                return -1;
            }
        }

        /// <summary>Gives the folder its final name. Everything must be written, cloud.json last of all.</summary>
        /// <exception cref="PointCloudException">It cannot be renamed, or belongs to another writer by now.</exception>
        public void Complete()
        {
            m_queue.End();
            m_isLost |= !m_lock.IsHeld;
            if (m_isLost)
                throw TakenOver();
            if (m_queue.Failure != null)
                throw m_queue.Failure;
            try
            {
                foreach (string folder in new[] { BuildFiles.RecordFolderName, BuildFiles.TopFolderName })
                    if (Directory.Exists(PathOf(folder)))
                        Directory.Delete(PathOf(folder), true);
                foreach (string name in new[] { StoreFormat.UpperName, StoreFormat.HierarchyName })
                    foreach (string file in Directory.GetFiles(m_part, name.Replace(".bin", "-*.bin")))
                        File.Delete(file);
                string old = null;
                if (Directory.Exists(m_target))
                {
                    StreamFiles.Leave(m_target);
                    old = m_target + ".old";
                    if (Directory.Exists(old))
                        Directory.Delete(old, true);
                    Directory.Move(m_target, old);
                }
                Directory.Move(m_part, m_target);
                m_isComplete = true;
                // The lock was renamed with the folder.
                File.Delete(Path.Combine(m_target, LockName));
                File.Delete(Path.Combine(m_target, BuildFiles.JournalName));
                if (old != null)
                    Directory.Delete(old, true);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(m_target, e);
            }
        }

        /// <summary>Keeps what was written when the writer is disposed, as if the process had been killed.</summary>
        public void Keep() => m_isKept = true;

        public void Dispose()
        {
            m_queue.End();
            if (m_isComplete)
                return;
            m_isComplete = true;
            if (!m_isKept && !m_isLost && m_lock.IsHeld)
                Delete(new DirectoryInfo(m_part));
            m_lock.Dispose();
        }

        /// <summary>Deletes what a build that ended early left of a target, unless it is being built now.</summary>
        public static void DeleteUnfinished(string target)
        {
            var part = new DirectoryInfo(target.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar) +
                StoreFormat.PartSuffix);
            if (!part.Exists)
                return;
            try
            {
                if (FolderLock.TryTake(Path.Combine(part.FullName, LockName), out var taken) != null)
                    return;
                Delete(part);
                taken.Dispose();
            }
            catch (PointCloudException)
            {
                // This is the same as if it could not be deleted.
            }
        }

        static void Delete(DirectoryInfo part)
        {
            try
            {
                part.Delete(true);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                // The rest has the temporary name, and the next build of this target clears it.
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
            string owner = FolderLock.TryTake(PathOf(LockName), out var taken);
            return taken ?? throw new PointCloudException(FailureCode.WriteFailed, m_target, -1, "is being built by " + owner);
        }

        /// <summary>Renews the lock on the writing thread.</summary>
        /// <returns>Why nothing may be written any more; null if the folder still belongs to this writer.</returns>
        PointCloudException RenewLock()
        {
            m_isLost |= !m_lock.Renew(DateTime.UtcNow);
            return m_isLost ? TakenOver() : null;
        }

        /// <summary>The failure when, after a long sleep of the machine, another writer has taken the folder over.</summary>
        PointCloudException TakenOver() =>
            new PointCloudException(FailureCode.WriteFailed, m_target, -1, "was taken over by another process");
    }
}
