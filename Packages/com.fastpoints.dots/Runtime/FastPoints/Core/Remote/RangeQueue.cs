using System;
using System.Buffers;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using System.Threading.Tasks;

namespace FastPoints
{
    // What is wanted of one server, and the few requests that are under way. Ranges wait here until a connection is free, so that
    // what is wanted most goes first and what nobody wants any more is never asked for.
    internal sealed class RangeQueue
    {
        // Larger ranges are cut, so that connections share them and what is urgent waits for no long one.
        public const int MaxRequestBytes = 1 << 20;
        const int MinGapBytes = 2 << 10; // A gap that costs less than a request's own headers.

        const int MaxGapBytes = 512 << 10;

        // At most one byte in so many of a request is one that nobody asked for, but for such gaps.
        const int UnusedBytesDivisor = 8;
        const int GatherDivisor = 16; // Part of a round trip that a request may be late by.
        const double FirstBytesPerConnection = 1 << 20; // Before anything was measured.

        // The rest of an answer that nobody wants is read on if that takes less than a new connection.
        const int DrainBytes = 64 << 10;

        static readonly Dictionary<string, RangeQueue> s_queues = new Dictionary<string, RangeQueue>();

        readonly object m_lock = new object();
        readonly List<Wanted> m_wanted = new List<Wanted>();
        int m_inFlight;
        long m_bytesInFlight;
        long m_begun;
        bool m_isMultiplexed;
        double m_roundTrip;
        double m_bytesPerSecond;
        double m_bytesPerConnection;

        struct Wanted
        {
            public RemoteRead Read;
            public int Part;

            // In the part.
            public long At;
            public long Offset;
            public long Bytes;
            public long Number;

            public readonly long End => Offset + Bytes;

            public readonly bool IsBefore(in Wanted other) =>
                Read.Rank != other.Read.Rank ? Read.Rank < other.Read.Rank : Number < other.Number;
        }

        public static RangeQueue Of(string server)
        {
            lock (s_queues)
            {
                if (!s_queues.TryGetValue(server, out var queue))
                    s_queues.Add(server, queue = new RangeQueue());
                return queue;
            }
        }

        // Requests under way, and answers that are not in the cache yet. For tests.
        public static int InFlight
        {
            get
            {
                int count = 0;
                lock (s_queues)
                    foreach (var queue in s_queues.Values)
                        lock (queue.m_lock)
                            count += queue.m_inFlight;
                return count;
            }
        }

        // Seconds from a request to its answer, the shortest lately; 0 before the first one.
        public double RoundTrip => Volatile.Read(ref m_roundTrip);

        public void Add(RemoteRead read, List<RangePiece> pieces)
        {
            lock (m_lock)
            {
                foreach (var piece in pieces)
                    m_wanted.Add(new Wanted
                    {
                        Read = read,
                        Part = piece.Part,
                        At = piece.At,
                        Offset = read.PartAt(piece.Part).Offset + piece.At,
                        Bytes = piece.Bytes,
                        Number = ++m_begun,
                    });
                // What is wanted in the next moment may lie beside it.
                int ms = (int)(m_roundTrip * 1000 / GatherDivisor);
                if (ms == 0)
                    BeginRequests();
                else
                    _ = BeginLater(ms);
            }
        }

        async Task BeginLater(int ms)
        {
            await Task.Delay(ms).ConfigureAwait(false);
            lock (m_lock)
                BeginRequests();
        }

        // Of what was asked for outside the queue, too.
        public void Measure(RangeExchange exchange)
        {
            double seconds = exchange.SecondsToHeaders;
            lock (m_lock)
            {
                m_isMultiplexed = exchange.IsMultiplexed;
                m_roundTrip = m_roundTrip == 0 ? seconds : Math.Min(seconds, m_roundTrip + 0.1 * (seconds - m_roundTrip));
            }
        }

        int MaxRequests => m_isMultiplexed ? RemoteSettings.Current.MaxStreams : RemoteSettings.Current.MaxConnections;

        void BeginRequests()
        {
            while (m_inFlight < MaxRequests && TryTakeBatch(out var batch))
            {
                m_inFlight++;
                m_bytesInFlight += batch.Bytes;
                Task.Run(() => Fetch(batch));
            }
        }

        // Bytes that a connection could have brought in the time of a round trip.
        int Gap() => (int)Math.Max(MinGapBytes, Math.Min(MaxGapBytes, m_roundTrip *
            (m_bytesPerConnection > 0 ? m_bytesPerConnection : FirstBytesPerConnection)));

        // The first of those that wait, and neighbours of it: rising, none twice.
        bool TryTakeBatch(out Batch batch)
        {
            batch = null;
            m_wanted.RemoveAll(w => w.Read.IsDone);
            if (m_wanted.Count == 0)
                return false;
            var first = m_wanted[0];
            foreach (var wanted in m_wanted)
                if (wanted.IsBefore(first))
                    first = wanted;
            // While the line is not full, bytes in gaps cost nothing, and a request less is a round trip less.
            bool isFull = m_bytesInFlight > m_roundTrip * m_bytesPerSecond;
            int gap = isFull ? MinGapBytes : Gap();
            var near = m_wanted.FindAll(w => w.Read.File == first.Read.File && w.End > first.Offset - MaxRequestBytes &&
                w.Offset < first.End + MaxRequestBytes);
            near.Sort((a, b) => a.Offset != b.Offset ? a.Offset.CompareTo(b.Offset) : a.Number.CompareTo(b.Number));
            batch = Batch.Around(near.FindIndex(w => w.Number == first.Number), near, gap);
            var taken = new HashSet<long>();
            foreach (var wanted in batch.Wanted)
                taken.Add(wanted.Number);
            m_wanted.RemoveAll(w => taken.Contains(w.Number));
            return true;
        }

        async Task Fetch(Batch batch)
        {
            var buffer = ArrayPool<byte>.Shared.Rent(batch.Bytes);
            long began = Stopwatch.GetTimestamp();
            try
            {
                await batch.File.Fetch(batch.Begin, batch.Bytes, buffer, bytes => batch.Deliver(buffer, bytes))
                    .ConfigureAwait(false);
            }
            catch (Exception e)
            {
                batch.Fail(PointCloudException.Of(batch.File.Name, e));
            }
            finally
            {
                ArrayPool<byte>.Shared.Return(buffer);
                RemoteStatistics.AddFetched(batch.Arrived, batch.Arrived - batch.Used);
                lock (m_lock)
                {
                    MeasureBytes(batch.Arrived, Stopwatch.GetTimestamp() - began);
                    m_inFlight--;
                    m_bytesInFlight -= batch.Bytes;
                    BeginRequests();
                }
            }
        }

        void MeasureBytes(long bytes, long ticks)
        {
            double seconds = ticks / (double)Stopwatch.Frequency - m_roundTrip;
            if (bytes < 16 << 10 || seconds <= 0)
                return;
            double rate = bytes / seconds;
            m_bytesPerConnection += (m_bytesPerConnection == 0 ? 1 : 0.2) * (rate - m_bytesPerConnection);
            double all = m_bytesPerConnection * m_inFlight;
            m_bytesPerSecond = Math.Max(all, 0.95 * m_bytesPerSecond);
        }

        // One request's.
        sealed class Batch
        {
            // Of those that their reads no longer wanted, too.
            readonly bool[] m_isTaken;
            readonly bool[] m_isUsed;

            // One of some that lie by offset, and its neighbours as far as they are near.
            public static Batch Around(int first, List<Wanted> all, int gap)
            {
                int from = first, to = first;
                long begin = all[first].Offset, end = all[first].End, wanted = all[first].Bytes;
                while (true)
                {
                    if (to + 1 < all.Count && Joins(all[to + 1]))
                        to++;
                    else if (from > 0 && Joins(all[from - 1]))
                        from--;
                    else
                        return new Batch(all.GetRange(from, to - from + 1), begin, end);
                }

                bool Joins(in Wanted next)
                {
                    long bytes = Math.Max(end, next.End) - Math.Min(begin, next.Offset);
                    long between = Math.Max(begin - next.End, next.Offset - end), unused = bytes - wanted - next.Bytes;
                    if (bytes > MaxRequestBytes || between > MinGapBytes &&
                        (between > gap || unused > bytes / UnusedBytesDivisor))
                        return false;
                    wanted += next.Bytes;
                    (begin, end) = (Math.Min(begin, next.Offset), Math.Max(end, next.End));
                    return true;
                }
            }

            Batch(List<Wanted> wanted, long begin, long end)
            {
                Wanted = wanted;
                Begin = begin;
                Bytes = (int)(end - begin);
                m_isTaken = new bool[wanted.Count];
                m_isUsed = new bool[wanted.Count];
            }

            public List<Wanted> Wanted { get; }
            public long Begin { get; }
            public int Bytes { get; }
            public int Arrived { get; private set; }

            public long Used
            {
                get
                {
                    long used = 0, counted = 0;
                    for (int i = 0; i < m_isUsed.Length; i++)
                    {
                        if (!m_isUsed[i])
                            continue;
                        used += Math.Max(0, Wanted[i].End - Math.Max(counted, Wanted[i].Offset));
                        counted = Math.Max(counted, Wanted[i].End);
                    }
                    return used;
                }
            }

            public IRangeSource File => Wanted[0].Read.File;

            // Gives reads their bytes as these come; returns whether more are wanted.
            public bool Deliver(byte[] buffer, int bytes)
            {
                Arrived = bytes;
                bool isWanted = false;
                for (int i = 0; i < m_isTaken.Length; i++)
                {
                    var wanted = Wanted[i];
                    if (m_isTaken[i] || (m_isTaken[i] = wanted.Read.IsDone))
                        continue;
                    if (wanted.End - Begin > bytes)
                    {
                        isWanted = true;
                        continue;
                    }
                    m_isTaken[i] = m_isUsed[i] = true;
                    wanted.Read.Receive(wanted.Part, wanted.At,
                        new ReadOnlySpan<byte>(buffer, (int)(wanted.Offset - Begin), (int)wanted.Bytes));
                }
                return isWanted || Bytes - bytes <= DrainBytes;
            }

            public void Fail(PointCloudException failure)
            {
                for (int i = 0; i < m_isTaken.Length; i++)
                    if (!m_isTaken[i])
                        Wanted[i].Read.Fail(failure);
            }
        }
    }

    // Of a read: some bytes of one of its parts, no more than one request brings.
    internal readonly struct RangePiece
    {
        public readonly int Part;
        public readonly long At;
        public readonly int Bytes;

        public RangePiece(int part, long at, int bytes) => (Part, At, Bytes) = (part, at, bytes);
    }
}
