using System;
using System.Buffers;
using System.Collections.Generic;
using System.Diagnostics;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using UnityEngine;

namespace FastPoints
{
    // A file of a web server. Its first bytes come with opening it.
    internal sealed class HttpFile : RemoteFile
    {
        // Many files may be opened at once: to wait for a connection must not look like a slow server.
        static readonly SemaphoreSlim s_opening = new SemaphoreSlim(new RemoteSettings().MaxConnections);

        // The one that was opened last, by address.
        static readonly Dictionary<string, HttpFile> s_opened = new Dictionary<string, HttpFile>();

        readonly RemoteTarget m_target;
        readonly RemoteIdentity m_identity;
        readonly RangeQueue m_queue;
        readonly FileVersionKey m_key;
        volatile byte[] m_head;
        long m_confirmed = Stopwatch.GetTimestamp();

        HttpFile(RemoteTarget target, RemoteIdentity identity, FileVersionKey key, byte[] head)
        {
            m_target = target;
            m_identity = identity;
            m_head = head;
            m_queue = RangeQueue.Of(target.Server);
            m_key = key;
        }

        // Works with domain reload off, too: registering twice is harmless.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Register() => Files = new HttpFiles();

        public override string Name => m_target.Address;
        public override long Length => m_identity.Length;
        public override string Identity => m_identity.ToString();
        public override bool HasVersion => m_identity.Tag.Length + m_identity.Modified.Length > 0;
        public override double RoundTrip => m_queue.RoundTrip;

        // Forgets the file, too: a cloud may have as many as nodes.
        public override void DropOpened()
        {
            m_head = null;
            lock (s_opened)
                if (s_opened.TryGetValue(m_target.Address, out var opened) && opened == this)
                    s_opened.Remove(m_target.Address);
        }

        public override void MarkStale() => Interlocked.Exchange(ref m_confirmed, long.MinValue / 2);

        public override void DropCached() => RangeCache.Current?.ForgetEntries(m_key);

        public override async Task Fetch(long offset, long count, byte[] into, Func<int, bool> arrived)
        {
            int got = 0;
            bool isWanted = true;
            bool Arrived(int bytes) => isWanted = arrived(bytes);
            await Retry(m_target, false, async () =>
            {
                if (got >= count || !isWanted)
                    return true;
                int before = got;
                using var exchange = await Begin(offset + got, count - got).ConfigureAwait(false);
                m_queue.Measure(exchange);
                if (exchange.Count < count - before)
                    throw new RemoteFault(FailureCode.Truncated, Name, offset + before, "wanted " +
                        NumberText.Of(count - before) + " bytes, got the file's end after " + NumberText.Of(exchange.Count));
                await exchange.Read(into, before, all => Arrived(got = before + all)).ConfigureAwait(false);
                Interlocked.Exchange(ref m_confirmed, Stopwatch.GetTimestamp());
                return true;
            }).ConfigureAwait(false);
            RangeCache.Current?.Add(m_key, offset, new ReadOnlySpan<byte>(into, 0, got));
        }

        async Task<RangeExchange> Begin(long offset, long count)
        {
            try
            {
                return await RangeExchange.Begin(m_target, offset, count, m_identity).ConfigureAwait(false);
            }
            catch (RemoteFault e) when (e.IsChanged)
            {
                MarkStale();
                throw;
            }
        }

        bool IsConfirmed => (Stopwatch.GetTimestamp() - Interlocked.Read(ref m_confirmed)) * 1000.0 / Stopwatch.Frequency <
            RemoteSettings.Current.ConfirmedMs;

        protected override void FindBytes(RemoteRead read) => Task.Run(() => FindCachedBytes(read));

        // What is on this machine is taken from there; the rest is asked for.
        void FindCachedBytes(RemoteRead read)
        {
            try
            {
                var missing = new List<RangePiece>();
                var cache = RangeCache.Current;
                var bytes = ArrayPool<byte>.Shared.Rent(RangeQueue.MaxRequestBytes);
                for (int part = 0; part < read.PartCount; part++)
                {
                    var command = read.PartAt(part);
                    for (long at = 0; at < command.Size && !read.IsDone; at += RangeQueue.MaxRequestBytes)
                    {
                        int count = (int)Math.Min(RangeQueue.MaxRequestBytes, command.Size - at);
                        var piece = bytes.AsSpan(0, count);
                        if (TryReadHead(command.Offset + at, piece) || TryReadCache(cache, command.Offset + at, piece))
                            read.Receive(part, at, piece);
                        else
                            missing.Add(new RangePiece(part, at, count));
                    }
                }
                ArrayPool<byte>.Shared.Return(bytes);
                if (missing.Count > 0)
                    m_queue.Add(read, missing);
            }
            catch (Exception e)
            {
                read.Fail(PointCloudException.Of(Name, e));
            }
        }

        bool TryReadCache(RangeCache cache, long offset, Span<byte> into)
        {
            bool has = cache != null && cache.TryRead(m_key, offset, into);
            if (has)
                RemoteStatistics.AddCacheHit();
            return has;
        }

        protected override bool TryReadHead(long offset, Span<byte> into)
        {
            byte[] head = m_head;
            if (head == null || offset < 0 || offset + into.Length > head.Length)
                return false;
            head.AsSpan((int)offset, into.Length).CopyTo(into);
            return true;
        }

        static async Task<HttpFile> OpenNow(string address, HttpFile opened, int headBytes)
        {
            var target = opened?.m_target ?? new RemoteTarget(address);
            var cache = RangeCache.Current;
            string key = RemoteKey.Of(address);
            var known = opened?.m_identity ?? FindIdentity(cache, key);
            byte[] head = opened?.m_head;
            RemoteIdentity identity;
            try
            {
                await s_opening.WaitAsync().ConfigureAwait(false);
                (identity, head) = await Retry(target, known != null, () => ReadHead(target, known, head, headBytes))
                    .ConfigureAwait(false);
            }
            catch (RemoteFault e) when (e.IsUnreachable && known != null)
            {
                identity = known;
            }
            finally
            {
                s_opening.Release();
            }
            lock (s_opened)
            {
                if (opened != null && opened.m_identity.Fits(identity))
                {
                    Interlocked.Exchange(ref opened.m_confirmed, Stopwatch.GetTimestamp());
                    return opened;
                }
                opened = s_opened[address] =
                    new HttpFile(target, identity, FileVersionKey.Of(key + "\n" + identity), head);
            }
            if (cache != null && head != null && known?.ToString() != identity.ToString())
            {
                cache.Add(opened.m_key, 0, head);
                cache.Add(FileVersionKey.Of(key), 0, Encoding.UTF8.GetBytes(identity.ToString()));
            }
            return opened;
        }

        // Of a version that is known one byte tells whether it is the server's still, and how long the file is. An answer by
        // If-None-Match would not: a length that was told wrong once would stay so.
        static async Task<(RemoteIdentity, byte[])> ReadHead(RemoteTarget target, RemoteIdentity known, byte[] knownHead,
            int headBytes)
        {
            bool isCheck = known != null && known.Length > HeadBytes;
            using var exchange = await RangeExchange.Begin(target, 0, isCheck ? 1 : headBytes, null).ConfigureAwait(false);
            RangeQueue.Of(target.Server).Measure(exchange);
            var head = new byte[exchange.Count];
            await exchange.Read(head, 0, all => true).ConfigureAwait(false);
            RemoteStatistics.AddFetched(head.Length, 0);
            if (!isCheck)
                return (exchange.Identity, head);
            return known.Fits(exchange.Identity) ? (known, knownHead)
                : await ReadHead(target, null, null, headBytes).ConfigureAwait(false);
        }

        static RemoteIdentity FindIdentity(RangeCache cache, string key)
        {
            byte[] text = cache?.ReadLastRange(FileVersionKey.Of(key));
            return text == null ? null : RemoteIdentity.Parse(Encoding.UTF8.GetString(text));
        }

        // Retries transient failures. hasCachedCopy: it is used instead, so an unreachable server is not retried.
        static async Task<T> Retry<T>(RemoteTarget target, bool hasCachedCopy, Func<Task<T>> attempt)
        {
            var settings = RemoteSettings.Current;
            bool isSigned = false;
            for (int tries = 1; ; tries++)
            {
                int delay;
                try
                {
                    return await attempt().ConfigureAwait(false);
                }
                catch (RemoteFault e)
                {
                    bool wasRedirected = target.Resolved != null;
                    target.Resolved = null;
                    if (e.IsDenied && !isSigned && (wasRedirected || RemoteAccess.Sign != null))
                    {
                        isSigned = true;
                        target.Signed(true);
                        continue;
                    }
                    if (hasCachedCopy && e.IsUnreachable)
                        throw;
                    if (!e.CanRetry || tries >= settings.MaxTries)
                        throw e.ToFailure();
                    int backOff = settings.RetryMs << (tries - 1);
                    delay = Math.Max(e.RetryAfterMs, backOff / 2 + Jitter(backOff / 2));
                }
                await Task.Delay(delay).ConfigureAwait(false);
            }
        }

        static int Jitter(int max)
        {
            lock (s_opened)
                return s_random.Next(max + 1);
        }

        static readonly System.Random s_random = new System.Random();

        // Forgets what was opened: for tests.
        internal static void Forget()
        {
            lock (s_opened)
                s_opened.Clear();
        }

        sealed class HttpFiles : IRemoteFiles
        {
            // Asks the server whether it still has that version, unless it said so a moment ago; without any answer, what the
            // cache has of it is good enough.
            public RemoteFile Open(string address, int headBytes)
            {
                var opened = (HttpFile)Find(address);
                if (opened != null && opened.IsConfirmed)
                    return opened;
                return Task.Run(() => OpenNow(address, opened, headBytes)).GetAwaiter().GetResult();
            }

            public RemoteFile Find(string address)
            {
                lock (s_opened)
                    return s_opened.TryGetValue(address, out var file) ? file : null;
            }

            public RemoteFile Of(string address, long length, string version) => new HttpFile(
                new RemoteTarget(address), new RemoteIdentity(length, null, null),
                FileVersionKey.Of(RemoteKey.Of(address) + "\n" + version), null);
        }
    }
}
