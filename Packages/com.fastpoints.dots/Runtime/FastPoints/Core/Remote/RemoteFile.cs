using System;
using System.Threading;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints
{
    // One file of a web server, as it was when it was opened: what comes from another version of it is refused.
    internal sealed unsafe class RemoteFile
    {
        RemoteFile(string address, long length)
        {
            Address = address;
            Length = length;
        }

        public string Address { get; }
        public long Length { get; }

        // Asks the server once for a file that is open already. Waits: never on an editor's or a player's main thread.
        public static RemoteFile Open(string address) => throw new NotImplementedException();

        // The one that was opened last, or null.
        public static RemoteFile Find(string address) => throw new NotImplementedException();

        // Into memory of the read's own, which the caller disposes. Any thread.
        public RemoteRead Begin(long offset, long bytes, int rank = 0) => throw new NotImplementedException();

        // Into the commands' buffers, which live until the read is done or cancelled. The commands themselves may go.
        public RemoteRead Begin(ReadCommand* commands, int count, int rank = 0) => throw new NotImplementedException();

        // Waits, like Open. Throws what the read fails with.
        public void Read(long offset, Span<byte> into) => throw new NotImplementedException();
    }

    // Since the process began, or Reset.
    internal static class RemoteStatistics
    {
        static long s_requests, s_bytesFetched, s_bytesUnused, s_cacheHits, s_waits;

        public static long Requests => Interlocked.Read(ref s_requests);
        public static long BytesFetched => Interlocked.Read(ref s_bytesFetched);

        // Fetched beside what was asked for: gaps between ranges, and what was cancelled on its way.
        public static long BytesUnused => Interlocked.Read(ref s_bytesUnused);

        // Ranges that the disk's cache had.
        public static long CacheHits => Interlocked.Read(ref s_cacheHits);

        // Reads that waited for bytes that nobody had fetched ahead: a fault, unless it was on a pool thread.
        public static long Waits => Interlocked.Read(ref s_waits);

        internal static void AddRequest(long bytes, long unused)
        {
            Interlocked.Increment(ref s_requests);
            Interlocked.Add(ref s_bytesFetched, bytes);
            Interlocked.Add(ref s_bytesUnused, unused);
        }

        internal static void AddCacheHit() => Interlocked.Increment(ref s_cacheHits);

        internal static void AddWait() => Interlocked.Increment(ref s_waits);

        public static void Reset()
        {
            Interlocked.Exchange(ref s_requests, 0);
            Interlocked.Exchange(ref s_bytesFetched, 0);
            Interlocked.Exchange(ref s_bytesUnused, 0);
            Interlocked.Exchange(ref s_cacheHits, 0);
            Interlocked.Exchange(ref s_waits, 0);
        }
    }
}
