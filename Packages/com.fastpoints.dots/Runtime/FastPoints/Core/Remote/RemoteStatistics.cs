using System.Threading;

namespace FastPoints
{
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

        // Reads that waited for bytes that nobody had fetched ahead.
        public static long Waits => Interlocked.Read(ref s_waits);

        internal static void AddRequest() => Interlocked.Increment(ref s_requests);

        internal static void AddFetched(long bytes, long unused)
        {
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
