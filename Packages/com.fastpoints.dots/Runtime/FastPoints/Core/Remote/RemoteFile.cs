using System;
using System.Threading;
using System.Threading.Tasks;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints
{
    // One file that is not on this machine, as it was when it was opened: what comes from another version of it is refused.
    internal abstract class RemoteFile : IRangeSource
    {
        public const int HeadBytes = 64 << 10;

        // Smaller files are soon here as a whole: they are sampled like those of this machine. Of larger ones a range costs a
        // request.
        public static long MaxSmallFileBytes = 32 << 20;

        // Who opens addresses: HttpFile of web servers, AssetFile of Android's streaming assets. They register themselves.
        public static IRemoteFiles Files, Assets;

        public abstract string Name { get; } // For messages: signatures are left out.

        public abstract long Length { get; }

        public abstract string Identity { get; } // Another value, another version of the file.

        public abstract bool HasVersion { get; } // Without, only another length tells that it is another file.

        public abstract double RoundTrip { get; } // Seconds that an answer takes to begin; 0 if none was seen yet.

        // Waits: on pool threads and in the command line alone. headBytes: so many of a new file come with it.
        public static RemoteFile Open(string address, int headBytes = HeadBytes) => FilesFor(address).Open(address, headBytes);

        // The one that was opened last, or null.
        public static RemoteFile Find(string address) => (SourcePath.IsStreamingAsset(address) ? Assets : Files)?.Find(address);

        // A file that another describes, so that nothing is asked before its first range: its length, and a text that is another
        // for other content. Any thread; it does not wait.
        public static RemoteFile Of(string address, long length, string version) =>
            FilesFor(address).Of(address, length, version);

        // Frees what came with opening it.
        public abstract void DropOpened();

        // The next Open asks the server.
        public abstract void MarkStale();

        // What came of it was wrong: it is asked for again.
        public abstract void DropCached();

        // Into memory of the read's own, which the caller disposes. Any thread.
        public RemoteRead Begin(long offset, long bytes, int rank = 0) => Begin(new RemoteRead(this, offset, bytes, rank));

        // Into the commands' buffers, which live until the read is done or cancelled. The commands themselves may go.
        public unsafe RemoteRead Begin(ReadCommand* commands, int count, int rank = 0) =>
            Begin(new RemoteRead(this, commands, count, rank));

        // Waits, like Open. Throws what the read fails with.
        public unsafe void Read(long offset, Span<byte> into)
        {
            if (into.Length == 0 || TryReadHead(offset, into))
                return;
            fixed (byte* first = into)
            {
                var command = new ReadCommand { Buffer = first, Offset = offset, Size = into.Length };
                using var read = Begin(&command, 1, int.MinValue);
                read.Await();
            }
        }

        public abstract Task Fetch(long offset, long count, byte[] into, Func<int, bool> arrived);

        // Finds its bytes, each within the file.
        protected abstract void FindBytes(RemoteRead read);

        RemoteRead Begin(RemoteRead read)
        {
            for (int part = 0; part < read.PartCount; part++)
            {
                var command = read.PartAt(part);
                if (command.Offset >= 0 && command.Size >= 0 && command.Offset <= Length - command.Size)
                    continue;
                MarkStale();
                read.Fail(PointCloudException.Wanted(FailureCode.Truncated, Name, Math.Max(0, command.Offset), "bytes",
                    command.Size, Math.Max(0, Length - command.Offset) + " before the end of the file"));
            }
            if (!read.IsDone)
                FindBytes(read);
            return read;
        }

        protected abstract bool TryReadHead(long offset, Span<byte> into);

        static IRemoteFiles FilesFor(string address) => (SourcePath.IsStreamingAsset(address) ? Assets : Files) ??
            throw new PointCloudException(FailureCode.Unsupported, SourcePath.WithoutQuery(address), -1,
                "this program reads no such addresses");
    }

    internal interface IRemoteFiles
    {
        RemoteFile Open(string address, int headBytes);

        RemoteFile Find(string address);

        RemoteFile Of(string address, long length, string version);
    }

    internal interface IRangeSource
    {
        string Name { get; } // For messages.

        // Fills the buffer from its start. arrived is called with the number of bytes so far; it returns whether more are wanted.
        Task Fetch(long offset, long count, byte[] into, Func<int, bool> arrived);
    }

    // Some bytes of a remote file, on their way to memory. Any thread may ask whether they have come; nothing waits but Await.
    // After Cancel no more is written: its memory may be freed at once.
    internal sealed unsafe class RemoteRead : IDisposable
    {
        readonly object m_lock = new object();
        readonly ReadCommand[] m_parts;
        byte* m_owned;
        long m_missing;
        volatile bool m_isDone;

        // Into memory of the caller, which lives until the read is done or cancelled.
        internal RemoteRead(IRangeSource file, ReadCommand* parts, int count, int rank)
        {
            File = file;
            Rank = rank;
            m_parts = new ReadCommand[count];
            for (int i = 0; i < count; i++)
                m_missing += (m_parts[i] = parts[i]).Size;
            m_isDone = m_missing == 0;
        }

        // Into memory of its own.
        internal RemoteRead(IRangeSource file, long offset, long bytes, int rank)
        {
            File = file;
            Rank = rank;
            m_owned = (byte*)UnsafeUtility.Malloc(Math.Max(1, bytes), 16, Allocator.Persistent);
            m_parts = new[] { new ReadCommand { Buffer = m_owned, Offset = offset, Size = bytes } };
            m_missing = bytes;
            m_isDone = bytes == 0;
        }

        public IRangeSource File { get; }

        public int Rank { get; set; } // What has the lowest rank is fetched first. It may change while the read waits.

        public bool IsDone => m_isDone;
        public bool IsCancelled { get; private set; }
        public PointCloudException Failure { get; private set; } // Once it is done: null if all bytes have come.

        public long Offset => m_parts[0].Offset;
        public long Bytes => m_parts[0].Size;
        public byte* Data => m_owned; // Of a read into memory of its own, once it is done: until Dispose.

        internal int PartCount => m_parts.Length;

        internal ReadCommand PartAt(int part) => m_parts[part];

        // On pool threads and in the command line alone. Throws the failure.
        public void Await()
        {
            lock (m_lock)
                while (!m_isDone)
                    Monitor.Wait(m_lock);
            if (Failure != null)
                throw Failure;
        }

        public void Cancel()
        {
            lock (m_lock)
            {
                IsCancelled |= !m_isDone;
                End();
            }
        }

        public void Dispose()
        {
            Cancel();
            if (m_owned != null)
                UnsafeUtility.Free(m_owned, Allocator.Persistent);
            m_owned = null;
        }

        // Takes bytes of a part, from an offset in it on; none may come twice. On the thread that has fetched them.
        internal void Receive(int part, long at, ReadOnlySpan<byte> bytes)
        {
            lock (m_lock)
            {
                if (m_isDone)
                    return;
                bytes.CopyTo(new Span<byte>((byte*)m_parts[part].Buffer + at, bytes.Length));
                m_missing -= bytes.Length;
                if (m_missing == 0)
                    End();
            }
        }

        internal void Fail(PointCloudException failure)
        {
            lock (m_lock)
            {
                if (m_isDone)
                    return;
                Failure = failure;
                End();
            }
        }

        void End()
        {
            m_isDone = true;
            Monitor.PulseAll(m_lock);
        }
    }

    // Since the process began, or Reset.
    internal static class RemoteStatistics
    {
        static long s_requests, s_bytesFetched, s_bytesUnused, s_cacheHits, s_waits;

        public static long Requests => Interlocked.Read(ref s_requests);
        public static long BytesFetched => Interlocked.Read(ref s_bytesFetched);

        // Fetched beside what was asked for: gaps between ranges, and what was cancelled on its way.
        public static long BytesUnused => Interlocked.Read(ref s_bytesUnused);
        public static long CacheHits => Interlocked.Read(ref s_cacheHits); // Ranges that the disk's cache had.
        public static long Waits => Interlocked.Read(ref s_waits); // Reads that waited for bytes that nobody had fetched ahead.

        internal static void AddRequest() => Interlocked.Increment(ref s_requests);

        internal static void AddFetched(long bytes, long unused)
        {
            Interlocked.Add(ref s_bytesFetched, bytes);
            Interlocked.Add(ref s_bytesUnused, unused);
        }

        internal static void AddCacheHit() => Interlocked.Increment(ref s_cacheHits);

        internal static void AddWait() => Interlocked.Increment(ref s_waits);

        // For tests.
        public static void Reset() => s_requests = s_bytesFetched = s_bytesUnused = s_cacheHits = s_waits = 0;
    }
}
