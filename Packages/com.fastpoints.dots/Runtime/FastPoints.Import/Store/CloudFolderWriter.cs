using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using System.Threading;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    /// <summary>
    /// Writes a cloud's folder under a temporary name, and gives it its own when everything is there. Each file is complete or
    /// absent: written under another name, flushed, renamed. One thread writes; callers never wait for a disk.
    /// </summary>
    /// <remarks>Disposed before <see cref="Complete"/>, it leaves nothing. A lock file keeps a second build of the same target
    /// out.</remarks>
    public sealed unsafe class CloudFolderWriter : IDisposable
    {
        const int PieceBytes = 1 << 20;
        const string LockName = "build.lock";
        const string TemporarySuffix = ".tmp";

        struct Order
        {
            public string Path;
            public IntPtr Bytes;
            public long Count;
            public WriteTicket Ticket;
        }

        readonly string m_target;
        readonly string m_part;
        readonly Queue<Order> m_orders = new Queue<Order>();
        readonly Thread m_thread;
        FileStream m_lock;
        bool m_isEnding;
        bool m_isComplete;
        long m_bytesWritten;

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
                m_lock = Lock(Path.Combine(m_part, LockName));
                DeleteContents();
                Directory.CreateDirectory(Path.Combine(m_part, StoreFormat.ChunkFolderName));
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                m_lock?.Dispose();
                throw FileFailures.Writing(m_part, e);
            }
            m_thread = new Thread(WriteOrders) { IsBackground = true, Name = "FastPoints writer" };
            m_thread.Start();
        }

        public long BytesWritten => Interlocked.Read(ref m_bytesWritten);

        /// <summary>Queues a file. The bytes belong to the writer until the ticket is done; no job may use them.</summary>
        public WriteTicket Write(string name, NativeArray<byte> bytes)
        {
            var ticket = new WriteTicket();
            lock (m_orders)
            {
                m_orders.Enqueue(new Order
                {
                    Path = Path.Combine(m_part, name),
                    Bytes = (IntPtr)bytes.GetUnsafeReadOnlyPtr(),
                    Count = bytes.Length,
                    Ticket = ticket,
                });
                Monitor.PulseAll(m_orders);
            }
            return ticket;
        }

        /// <summary>Writes cloud.json last of all, and gives the folder its name. Everything queued is done.</summary>
        public void Complete(CloudManifest manifest)
        {
            EndThread();
            try
            {
                byte[] json = new UTF8Encoding(false).GetBytes(manifest.ToJson());
                fixed (byte* bytes = json)
                    WriteFile(Path.Combine(m_part, StoreFormat.ManifestName), bytes, json.Length);
                m_lock.Dispose();
                m_lock = null;
                File.Delete(Path.Combine(m_part, LockName));
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
                if (old != null)
                    Directory.Delete(old, true);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(m_target, e);
            }
        }

        public void Dispose()
        {
            EndThread();
            m_lock?.Dispose();
            m_lock = null;
            if (m_isComplete)
                return;
            m_isComplete = true;
            try
            {
                Directory.Delete(m_part, true);
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

        FileStream Lock(string path)
        {
            try
            {
                return new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
            }
            catch (IOException e)
            {
                throw new PointCloudException(FailureCode.WriteFailed, m_target, -1, "is being built by another process", e);
            }
        }

        /// <summary>What a build that was killed has left.</summary>
        void DeleteContents()
        {
            foreach (string folder in Directory.GetDirectories(m_part))
                Directory.Delete(folder, true);
            foreach (string file in Directory.GetFiles(m_part))
                if (Path.GetFileName(file) != LockName)
                    File.Delete(file);
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
                    while (m_orders.Count == 0 && !m_isEnding)
                        Monitor.Wait(m_orders);
                    if (m_orders.Count == 0)
                        return;
                    order = m_orders.Dequeue();
                }
                Exception failure = null;
                try
                {
                    WriteFile(order.Path, (byte*)order.Bytes, order.Count);
                }
                catch (Exception e) when (FileFailures.IsFileFailure(e))
                {
                    failure = FileFailures.Writing(order.Path, e);
                }
                order.Ticket.Finish(failure);
            }
        }

        void WriteFile(string path, byte* bytes, long count)
        {
            string temporary = path + TemporarySuffix;
            using (var file = new FileStream(temporary, FileMode.Create, FileAccess.Write, FileShare.None, 1))
            {
                for (long done = 0; done < count;)
                {
                    int piece = (int)Math.Min(PieceBytes, count - done);
                    file.Write(new ReadOnlySpan<byte>(bytes + done, piece));
                    done += piece;
                    Interlocked.Add(ref m_bytesWritten, piece);
                }
                file.Flush(true);
            }
            File.Move(temporary, path);
        }
    }
}
