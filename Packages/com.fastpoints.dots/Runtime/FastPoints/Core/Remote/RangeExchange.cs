using System;
using System.Buffers;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Net;
using System.Net.Http;
using System.Threading;
using System.Threading.Tasks;

namespace FastPoints
{
    // One request for a range of a file. Nothing that a server says is trusted: status, range, length, version and encoding are
    // checked before a byte is taken.
    internal sealed class RangeExchange : IDisposable
    {
        const int PieceBytes = 64 << 10;

        static readonly object s_lock = new object();
        internal static HttpClient s_client;

        readonly string m_address;
        readonly long m_offset;
        readonly long m_count;
        HttpResponseMessage m_response;

        RangeExchange(string address, long offset, long count)
        {
            m_address = address;
            m_offset = offset;
            m_count = count;
        }

        internal static Func<HttpMessageHandler> CreateHandler; // For tests; it takes effect with the next client.

        // What servers are asked for by TLS. The command line sets HTTP/2, which Unity's runtime has not.
        internal static Version HttpVersion = System.Net.HttpVersion.Version11;

        public RemoteIdentity Identity { get; private set; }

        public long Count { get; private set; } // Bytes that will come: fewer than were asked for only at the file's end.

        public double SecondsToHeaders { get; private set; }

        public bool IsMultiplexed => m_response.Version.Major > 1; // Its connection carries others meanwhile.

        // expected: null if this is what the range is to say.
        public static async Task<RangeExchange> Begin(RemoteTarget target, long offset, long count, RemoteIdentity expected)
        {
            var exchange = new RangeExchange(target.Address, offset, count);
            try
            {
                await exchange.Send(target).ConfigureAwait(false);
                exchange.CheckHeaders(expected);
                return exchange;
            }
            catch
            {
                exchange.Dispose();
                throw;
            }
        }

        // Fills the array from an index on, up to Count bytes; got is called with all bytes so far, and returns whether more are
        // wanted. Returns the number of bytes.
        public async Task<int> Read(byte[] into, int at, Func<int, bool> got)
        {
            var settings = RemoteSettings.Current;
            var watch = Stopwatch.StartNew();
            // A read that was given up may still write: into what nobody else uses, for it is returned after whole reads alone.
            byte[] piece = ArrayPool<byte>.Shared.Rent((int)Math.Min(Count, PieceBytes));
            int all = 0;
            try
            {
                using var body = await Limit(m_response.Content.ReadAsStreamAsync(), settings.StallMs).ConfigureAwait(false);
                while (all < Count)
                {
                    int read = await Limit(body.ReadAsync(piece, 0, (int)Math.Min(Count - all, piece.Length)), settings.StallMs)
                        .ConfigureAwait(false);
                    if (read == 0)
                        throw Fault(all, "the answer is too short: wanted " + NumberText.Of(Count) + " bytes, got " +
                            NumberText.Of(all));
                    Buffer.BlockCopy(piece, 0, into, at + all, read);
                    all += read;
                    if (!got(all))
                        break;
                    long ms = watch.ElapsedMilliseconds;
                    if (ms > settings.StallMs && all < Count && all * 1000L / ms < settings.MinBytesPerSecond)
                        throw Fault(all, "the server is too slow: got " + NumberText.Of(all) + " of " + NumberText.Of(Count) +
                            " bytes in " + NumberText.Of(ms / 1000) + " s");
                }
                ArrayPool<byte>.Shared.Return(piece);
                return all;
            }
            catch (Exception e) when (IsConnectionFailure(e))
            {
                throw Fault(all, "the connection broke: " + Line(e));
            }
        }

        public void Dispose() => m_response?.Dispose();

        async Task Send(RemoteTarget target)
        {
            var watch = Stopwatch.StartNew();
            var uri = target.Resolved ?? target.Signed(false);
            for (int redirects = 0; ; redirects++)
            {
                CheckScheme(uri);
                m_response?.Dispose();
                try
                {
                    using var request = Request(target, uri);
                    RemoteStatistics.AddRequest();
                    m_response = await Limit(Client().SendAsync(request, HttpCompletionOption.ResponseHeadersRead),
                        RemoteSettings.Current.StallMs).ConfigureAwait(false);
                }
                catch (Exception e) when (IsConnectionFailure(e))
                {
                    target.Resolved = null;
                    throw new RemoteFault(FailureCode.ReadFailed, m_address, m_offset, "the server cannot be reached: " + Line(e))
                    {
                        CanRetry = true,
                        IsUnreachable = true,
                    };
                }
                int status = (int)m_response.StatusCode;
                if (status != 301 && status != 302 && status != 303 && status != 307 && status != 308)
                    break;
                var to = m_response.Headers.Location;
                if (to == null || redirects == RemoteSettings.Current.MaxRedirects)
                    throw Fault(0, to == null ? "a redirect leads nowhere" : "more than " +
                        NumberText.Of(RemoteSettings.Current.MaxRedirects) + " redirects");
                to = to.IsAbsoluteUri ? to : new Uri(uri, to);
                if (uri.Scheme == "https" && to.Scheme != "https")
                    throw Refused("redirects from https to " + to.Scheme);
                target.Resolved = uri = to;
            }
            SecondsToHeaders = watch.Elapsed.TotalSeconds;
        }

        HttpRequestMessage Request(RemoteTarget target, Uri uri)
        {
            var request = new HttpRequestMessage(HttpMethod.Get, uri) { Version = HttpVersion };
            string last = (m_offset + m_count - 1).ToString(CultureInfo.InvariantCulture);
            request.Headers.TryAddWithoutValidation("Range", "bytes=" + NumberText.Of(m_offset) + "-" + last);
            // A compressed answer has other bytes at the range's offsets.
            request.Headers.TryAddWithoutValidation("Accept-Encoding", "identity");
            if (RemoteAccess.AddHeaders == null || !target.IsOrigin(uri))
                return request;
            var headers = new Dictionary<string, string>();
            RemoteAccess.AddHeaders(uri, headers);
            foreach (var header in headers)
                request.Headers.TryAddWithoutValidation(header.Key, header.Value);
            return request;
        }

        void CheckHeaders(RemoteIdentity expected)
        {
            int status = (int)m_response.StatusCode;
            if (status != 206 && status != 200)
                throw StatusFault(status);
            foreach (string encoding in m_response.Content.Headers.ContentEncoding)
                if (!string.Equals(encoding, "identity", StringComparison.OrdinalIgnoreCase))
                    throw Refused("the answer is compressed (" + encoding + "), wanted the file's own bytes");
            long length = status == 206 ? CheckRange() : CheckWhole();
            Identity = new RemoteIdentity(length, FirstOf("ETag"), FirstOf("Last-Modified"));
            if (expected != null && !expected.Fits(Identity))
                throw new RemoteFault(FailureCode.Changed, m_address, m_offset, "the file has changed on the server since it " +
                    "was opened: wanted " + NumberText.Of(expected.Length) + " bytes " + expected.Tag + ", got " +
                    NumberText.Of(length) + " bytes " + Identity.Tag)
                {
                    IsChanged = true,
                };
            Count = Math.Min(m_count, length - m_offset);
            long? announced = m_response.Content.Headers.ContentLength;
            if (announced != null && announced != Count)
                throw Fault(0, "length of the answer: wanted " + NumberText.Of(Count) + " bytes, got " +
                    NumberText.Of(announced.Value));
        }

        // Returns the file's length.
        long CheckRange()
        {
            var range = m_response.Content.Headers.ContentRange;
            if (range == null || !range.HasRange || !range.HasLength)
                throw Fault(0, "a part without a range and the file's length: got Content-Range " +
                    (range?.ToString() ?? "(none)"));
            long wantedEnd = Math.Min(m_offset + m_count, range.Length.Value);
            if (range.From != m_offset || range.To != wantedEnd - 1)
                throw Fault(0, "range of the answer: wanted bytes " + NumberText.Of(m_offset) + " to " +
                    NumberText.Of(wantedEnd - 1) + ", got " + range);
            return range.Length.Value;
        }

        // A server without ranges is good enough for a file that is wanted whole.
        long CheckWhole()
        {
            long? length = m_response.Content.Headers.ContentLength;
            if (m_offset == 0 && length != null && length <= m_count)
                return length.Value;
            throw Refused("the server sends whole files and no ranges: wanted status 206, got 200");
        }

        RemoteFault StatusFault(int status)
        {
            string what = "the server answered " + NumberText.Of(status);
            switch (status)
            {
                case 401:
                case 403:
                    return new RemoteFault(FailureCode.AccessDenied, m_address, -1, what + ": permission denied")
                    {
                        IsDenied = true,
                    };
                case 404:
                case 410:
                    return new RemoteFault(FailureCode.NotFound, m_address, -1, what + ": no such file");
                case 416:
                    long? length = m_response.Content.Headers.ContentRange?.Length;
                    return length == 0
                        ? new RemoteFault(FailureCode.Truncated, m_address, -1, "wanted a point cloud, got 0 bytes")
                        : Fault(0, what + ": it has no such range, of " + (length == null ? "?" : NumberText.Of(length.Value)) +
                            " bytes");
                case 408:
                case 429:
                    return Retried(what);
                default:
                    return status >= 500 ? Retried(what) : Refused(what);
            }
        }

        RemoteFault Retried(string what)
        {
            var after = m_response.Headers.RetryAfter;
            double ms = after?.Delta?.TotalMilliseconds ??
                (after?.Date == null ? 0 : (after.Date.Value - DateTimeOffset.UtcNow).TotalMilliseconds);
            var fault = Fault(0, what);
            fault.RetryAfterMs = (int)Math.Max(0, Math.Min(ms, RemoteSettings.Current.MaxRetryAfterMs));
            return fault;
        }

        RemoteFault Fault(long at, string what) =>
            new RemoteFault(FailureCode.ReadFailed, m_address, m_offset + at, what) { CanRetry = true };

        RemoteFault Refused(string what) => new RemoteFault(FailureCode.ReadFailed, m_address, m_offset, what);

        void CheckScheme(Uri uri)
        {
            if (uri.Scheme == "https" || uri.Scheme == "http" && (uri.IsLoopback || RemoteAccess.AllowsHttp))
                return;
            throw new RemoteFault(FailureCode.AccessDenied, m_address, -1, uri.Scheme == "http"
                ? "wanted https, got http, which anybody on the way can read and change (RemoteAccess.AllowsHttp, --allow-http)"
                : "wanted https, got " + uri.Scheme);
        }

        string FirstOf(string header)
        {
            if (m_response.Headers.TryGetValues(header, out var values) ||
                m_response.Content.Headers.TryGetValues(header, out values))
                foreach (string value in values)
                    return value.Replace('\n', ' ');
            return null;
        }

        // Runtimes differ in what of a request they cancel: what takes too long is left behind, and its connection closed.
        async Task<T> Limit<T>(Task<T> task, int ms)
        {
            using var timer = new CancellationTokenSource();
            if (await Task.WhenAny(task, Task.Delay(ms, timer.Token)).ConfigureAwait(false) == task)
            {
                timer.Cancel();
                return await task.ConfigureAwait(false);
            }
            m_response?.Dispose();
            _ = task.ContinueWith(Drop, TaskScheduler.Default);
            throw new IOException("nothing came for " + NumberText.Of(ms) + " ms");
        }

        static void Drop<T>(Task<T> late)
        {
            if (late.Status == TaskStatus.RanToCompletion)
                (late.Result as IDisposable)?.Dispose();
            else
                _ = late.Exception; // It counts as observed.
        }

        // .NET's own client lets a status of a broken line fail as an argument.
        static bool IsConnectionFailure(Exception e) => e is HttpRequestException || e is IOException ||
            e is OperationCanceledException || e is ObjectDisposedException || e is WebException ||
            e is ArgumentOutOfRangeException;

        static string Line(Exception e)
        {
            while (e.InnerException != null)
                e = e.InnerException;
            return e.Message.Replace('\n', ' ');
        }

        static HttpClient Client()
        {
            lock (s_lock)
            {
                return s_client ??= new HttpClient(CreateHandler?.Invoke() ?? new HttpClientHandler
                {
                    AllowAutoRedirect = false,
                    AutomaticDecompression = DecompressionMethods.None,
                    MaxConnectionsPerServer = RemoteSettings.Current.MaxConnections,
                    UseCookies = false,
                })
                {
                    Timeout = Timeout.InfiniteTimeSpan,
                };
            }
        }
    }

    // Where a file is asked for: its address, signed if need be, or where a redirect has led.
    internal sealed class RemoteTarget
    {
        readonly Uri m_uri;
        Uri m_signed;

        public RemoteTarget(string address)
        {
            Address = SourcePath.WithoutQuery(address);
            if (!Uri.TryCreate(address, UriKind.Absolute, out m_uri))
                throw new PointCloudException(FailureCode.NotFound, Address, -1, "is not an address");
        }

        public string Address { get; } // For messages.

        public string Server => m_uri.Scheme + "://" + m_uri.Authority;
        public volatile Uri Resolved; // Forgotten when it fails.

        public Uri Signed(bool wasRefused)
        {
            if (m_signed == null || wasRefused)
                m_signed = RemoteAccess.Sign?.Invoke(m_uri, wasRefused) ?? m_uri;
            return m_signed;
        }

        // Headers with tokens are for the address's own host, not for where it redirects to.
        public bool IsOrigin(Uri uri) => uri.Scheme == m_uri.Scheme && uri.Authority == m_uri.Authority;
    }

    internal sealed class RemoteFault : Exception
    {
        readonly FailureCode m_code;
        readonly string m_address;
        readonly long m_offset;
        readonly string m_what;

        public RemoteFault(FailureCode code, string address, long offset, string what) : base(what)
        {
            m_code = code;
            m_address = address;
            m_offset = offset;
            m_what = what;
        }

        public bool CanRetry { get; set; }

        public bool IsDenied { get; set; } // Another signature may help.

        public bool IsChanged { get; set; } // Of another version than what was opened.

        // No answer came at all.
        public bool IsUnreachable { get; set; }
        public int RetryAfterMs { get; set; }

        public PointCloudException ToFailure() => new PointCloudException(m_code, m_address, m_offset, m_what);
    }
}
