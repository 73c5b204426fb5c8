using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using System.Threading;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Octree;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    /// <summary>
    /// Writes a cloud's folder under a temporary name, and gives it its own when everything is there. Each file is complete or
    /// absent: written under another name, flushed, renamed. One thread writes; callers never wait for a disk.
    /// </summary>
    /// <remarks>Disposed before <see cref="Complete"/>, it leaves nothing, or what <see cref="Keep"/> keeps. A lock file keeps a
    /// second build of the same target out.</remarks>
    public sealed unsafe class CloudFolderWriter : IDisposable
    {
        const int PieceBytes = 1 << 20;
        const string LockName = "build.lock";
        const string TemporarySuffix = ".tmp";

        enum OrderKind
        {
            /// <summary>A file in one piece.</summary>
            Whole,
            /// <summary>A piece of a file that has its temporary name still.</summary>
            Piece,
            /// <summary>The first bytes of such a file, which is complete then.</summary>
            Seal,
            /// <summary>Records at the end of a file that the build alone reads.</summary>
            Records,
            /// <summary>What was written to such a file so far is put on the disk itself.</summary>
            Sync,
        }

        struct Order
        {
            public OrderKind Kind;
            public string Path;
            public IntPtr Bytes;
            public long Count;
            public long Offset;
            public RecordPages Pages;
            public int StrideBytes;
            public WriteTicket Ticket;
        }

        readonly string m_target;
        readonly string m_part;
        readonly Queue<Order> m_orders = new Queue<Order>();
        readonly Thread m_thread;
        readonly FolderLock m_lock;
        Exception m_failure;
        bool m_isEnding;
        bool m_isLost;
        bool m_isComplete;
        bool m_isKept;

        /// <param name="target">The folder to be: absent, empty, or a cloud that the new one replaces.</param>
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
            m_thread = new Thread(WriteOrders) { IsBackground = true, Name = "FastPoints writer" };
            m_thread.Start();
        }

        /// <summary>Whether a build of this target was killed before.</summary>
        public bool HasLeftovers { get; }

        /// <summary>What a build that was killed says of itself, or null where there is none.</summary>
        public string ReadText(string name) => File.Exists(PathOf(name)) ? StoreFile.ReadText(PathOf(name)) : null;

        /// <summary>Writes a small file on the calling thread, in place of the one of that name.</summary>
        public void WriteText(string name, string text)
        {
            try
            {
                byte[] bytes = new UTF8Encoding(false).GetBytes(text);
                fixed (byte* first = bytes)
                    WriteFile(PathOf(name), first, bytes.Length);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(PathOf(name), e);
            }
        }

        /// <summary>Cuts a file to a size; 0 deletes it.</summary>
        /// <returns>Whether it has that size now: false where it was shorter.</returns>
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
                using (var file = new FileStream(path, FileMode.Open, FileAccess.Write))
                {
                    if (file.Length < bytes)
                        return false;
                    file.SetLength(bytes);
                    return true;
                }
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }

        /// <summary>Deletes what is in a folder of the build.</summary>
        /// <param name="kept">Paths that are not deleted.</param>
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

        /// <summary>Deletes everything that is there: the build begins anew.</summary>
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
        public WriteTicket Write(string name, NativeArray<byte> bytes) => Enqueue(OrderKind.Whole, name, bytes, 0);

        /// <summary>Queues a piece of a file, which is there when <see cref="Seal"/> is done with it. The bytes belong to the
        /// writer
        /// until the ticket is done.</summary>
        /// <param name="offset">Of the piece in the file.</param>
        public WriteTicket WritePiece(string name, NativeArray<byte> bytes, long offset) =>
            Enqueue(OrderKind.Piece, name, bytes, offset);

        /// <summary>Queues the first bytes of a file in pieces, with which it is complete.</summary>
        public WriteTicket Seal(string name, NativeArray<byte> bytes) => Enqueue(OrderKind.Seal, name, bytes, 0);

        /// <summary>Queues records for a temporary file. The pages belong to the writer until the ticket is done.</summary>
        /// <param name="offset">The file's size so far.</param>
        public WriteTicket WriteRecords(string name, in RecordPages pages, int strideBytes, long offset) => Enqueue(new Order
        {
            Kind = OrderKind.Records,
            Path = Path.Combine(m_part, name),
            Pages = pages,
            StrideBytes = strideBytes,
            Offset = offset,
            Ticket = new WriteTicket(),
        });

        /// <summary>Queues that what was queued for a temporary file before is on the disk itself, not in the system's memory
        /// alone, when the ticket is done: a loss of power takes nothing of it.</summary>
        public WriteTicket SyncRecords(string name) => Enqueue(new Order
        {
            Kind = OrderKind.Sync,
            Path = Path.Combine(m_part, name),
            Ticket = new WriteTicket(),
        });

        /// <summary>Path of a file of the folder while it is in the making.</summary>
        public string PathOf(string name) => Path.Combine(m_part, name);

        /// <summary>Deletes a file that the build needs no more; nothing is queued for it.</summary>
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

        /// <summary>Deletes the files of one generation of the cloud in the making, where they are.</summary>
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

        /// <summary>Bytes that the target's disk has room for; -1 where nobody says.</summary>
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

        /// <summary>Gives the folder its name. Everything is written, cloud.json last of all.</summary>
        /// <exception cref="PointCloudException">It cannot, or is another writer's by now.</exception>
        public void Complete()
        {
            EndThread();
            CheckLock();
            if (m_failure != null)
                throw m_failure;
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
                    old = m_target + ".old";
                    if (Directory.Exists(old))
                        Directory.Delete(old, true);
                    Directory.Move(m_target, old);
                }
                Directory.Move(m_part, m_target);
                m_isComplete = true;
                // The lock has come along.
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

        /// <summary>What was written stays when the writer is disposed, as if the process had been killed then.</summary>
        public void Keep() => m_isKept = true;

        public void Dispose()
        {
            EndThread();
            if (m_isComplete)
                return;
            m_isComplete = true;
            CheckLock();
            if (!m_isKept && !m_isLost)
                Delete(new DirectoryInfo(m_part));
            m_lock.Dispose();
        }

        /// <summary>Deletes what a build that ended early left of a target; nothing where it is being built now.</summary>
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
                // As where it cannot be deleted.
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
                // What is left has the temporary name, and the next build of this target clears it.
            }
        }

        void CheckReplaceable(string target)
        {
            if (File.Exists(m_target))
                throw new PointCloudException(FailureCode.WriteFailed, target, -1, "is a file, wanted a folder to be made");
            if (!Directory.Exists(m_target) || File.Exists(Path.Combine(m_target, StoreFormat.ManifestName)))
                return;
            using (var entries = Directory.EnumerateFileSystemEntries(m_target).GetEnumerator())
            {
                if (entries.MoveNext())
                    throw new PointCloudException(FailureCode.WriteFailed, target, -1,
                        "is a folder with other things in it: wanted none, or a cloud to replace");
            }
        }

        FolderLock Lock()
        {
            string owner = FolderLock.TryTake(PathOf(LockName), out var taken);
            return taken ?? throw new PointCloudException(FailureCode.WriteFailed, m_target, -1, "is being built by " + owner);
        }

        void RenewLock()
        {
            if (!m_isLost && !m_lock.Renew(DateTime.UtcNow))
                LoseLock();
        }

        void CheckLock()
        {
            if (!m_isLost && !m_lock.IsHeld)
                LoseLock();
        }

        /// <summary>After a long sleep of the machine another one may have taken this writer for gone: the folder is
        /// his.</summary>
        void LoseLock()
        {
            m_isLost = true;
            m_failure = new PointCloudException(FailureCode.WriteFailed, m_target, -1, "was taken over by another process");
        }

        void EndThread()
        {
            lock (m_orders)
            {
                m_isEnding = true;
                Monitor.PulseAll(m_orders);
            }
            m_thread.Join();
        }

        void WriteOrders()
        {
            while (true)
            {
                Order order;
                lock (m_orders)
                {
                    if (m_orders.Count == 0 && !m_isEnding)
                        Monitor.Wait(m_orders, FolderLock.RenewAfter);
                    if (m_orders.Count == 0 && m_isEnding)
                        return;
                    m_orders.TryDequeue(out order);
                }
                RenewLock();
                if (order.Ticket == null)
                    continue;
                // After a failure nothing is written any more: what follows would rely on what is missing.
                try
                {
                    if (m_failure == null)
                        Carry(order);
                }
                catch (Exception e) when (FileFailures.IsFileFailure(e))
                {
                    m_failure = FileFailures.Writing(order.Path, e);
                }
                order.Ticket.Finish(m_failure);
            }
        }

        WriteTicket Enqueue(OrderKind kind, string name, NativeArray<byte> bytes, long offset) => Enqueue(new Order
        {
            Kind = kind,
            Path = Path.Combine(m_part, name),
            Bytes = (IntPtr)bytes.GetUnsafeReadOnlyPtr(),
            Count = bytes.Length,
            Offset = offset,
            Ticket = new WriteTicket(),
        });

        WriteTicket Enqueue(Order order)
        {
            lock (m_orders)
            {
                m_orders.Enqueue(order);
                Monitor.PulseAll(m_orders);
            }
            return order.Ticket;
        }

        void Carry(in Order order)
        {
            var bytes = (byte*)order.Bytes;
            string temporary = order.Path + TemporarySuffix;
            switch (order.Kind)
            {
                case OrderKind.Whole:
                    WriteFile(order.Path, bytes, order.Count);
                    break;
                case OrderKind.Piece:
                    using (var file = Open(temporary, order.Offset == 0 ? FileMode.Create : FileMode.OpenOrCreate, order.Offset))
                        Write(file, bytes, order.Count);
                    break;
                case OrderKind.Seal:
                    using (var file = Open(temporary, FileMode.OpenOrCreate, 0))
                    {
                        Write(file, bytes, order.Count);
                        file.Flush(true);
                    }
                    Rename(temporary, order.Path);
                    break;
                case OrderKind.Sync:
                    using (var file = new FileStream(order.Path, FileMode.Open, FileAccess.Write))
                        file.Flush(true);
                    break;
                default:
                    using (var file = Open(order.Path, FileMode.OpenOrCreate, order.Offset))
                        for (var page = order.Pages.First; page != null; page = page->Next)
                            file.Write(new ReadOnlySpan<byte>(RecordPages.RecordsOf(page), page->Count * order.StrideBytes));
                    break;
            }
        }

        void WriteFile(string path, byte* bytes, long count)
        {
            string temporary = path + TemporarySuffix;
            using (var file = Open(temporary, FileMode.Create, 0))
            {
                Write(file, bytes, count);
                file.Flush(true);
            }
            Rename(temporary, path);
        }

        static FileStream Open(string path, FileMode mode, long offset)
        {
            // A buffer of one byte: what is written goes straight on.
            var file = new FileStream(path, mode, FileAccess.Write, FileShare.Read, 1);
            file.Position = offset;
            return file;
        }

        static void Write(FileStream file, byte* bytes, long count)
        {
            for (long done = 0; done < count;)
            {
                int piece = (int)Math.Min(PieceBytes, count - done);
                file.Write(new ReadOnlySpan<byte>(bytes + done, piece));
                done += piece;
            }
        }

        /// <summary>In place of what is there, if anything is.</summary>
        static void Rename(string from, string to)
        {
            if (File.Exists(to))
                File.Replace(from, to, null);
            else
                File.Move(from, to);
        }
    }
}
