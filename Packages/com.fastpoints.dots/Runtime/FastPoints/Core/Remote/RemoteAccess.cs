using System;
using System.Collections.Generic;

namespace FastPoints
{
    /// <summary>How clouds are read from web servers. Set it before a cloud is opened; what it returns is never stored or
    /// shown.</summary>
    public static class RemoteAccess
    {
        /// <summary>Returns the address to ask for a file, such as a signed one, or null for the same. The second argument: the
        /// server has refused the last one (401 or 403). Any thread, several at once.</summary>
        public static Func<Uri, bool, Uri> Sign { get; set; }

        /// <summary>Adds headers to a request, such as Authorization. Any thread, several at once.</summary>
        public static Action<Uri, IDictionary<string, string>> AddHeaders { get; set; }

        /// <summary>Allows addresses with http://, which anybody on the way can read and change. This machine's own are always
        /// allowed.</summary>
        public static bool AllowsHttp { get; set; }

        /// <summary>The folder of the cache, or null for one folder a user. Several processes may share it.</summary>
        public static string CacheFolder { get; set; }

        /// <summary>Bytes of the cache on disk at most, about; 0 for none.</summary>
        public static long CacheBytes { get; set; } = 4L << 30;
    }

    // What tests shorten.
    internal sealed class RemoteSettings
    {
        public static RemoteSettings Current = new RemoteSettings();
        public int StallMs = 15000; // Until the first byte of an answer, and between two pieces of it.
        public int MinBytesPerSecond = 2048; // A body that is slower on average, after StallMs, is given up.

        public int MaxTries = 4;
        public int RetryMs = 250; // Doubles from try to try; half of it is random.

        public int MaxRetryAfterMs = 20000;
        public int MaxRedirects = 5;
        public int MaxConnections = 8;
        public int MaxStreams = 16; // By HTTP/2, which has one connection.
        public int ConfirmedMs = 10000; // An answer that confirmed a file's identity counts for so long when it is opened again.
    }
}
