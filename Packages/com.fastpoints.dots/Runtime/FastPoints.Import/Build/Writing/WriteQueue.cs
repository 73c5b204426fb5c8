using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using FastPoints.Nodes;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>One thread that writes files in the order in which they are queued. Each file is complete or absent: it is
    /// written under another name, flushed, then renamed. After a failure nothing more is written.</summary>
    sealed unsafe class WriteQueue
    {
        const int PieceBytes = 1 << 20;
        public const string TemporarySuffix = ".tmp"; // Ends the name of a file that is not whole.

        enum WriteKind
        {
            Whole,
            Piece, // A piece of a file that still has its temporary name.
            Seal, // The first bytes of such a file, which complete it.
            Records, // Records at the end of a file that only the build reads.
            Sync, // A flush to disk of what was written to such a file so far.
            Call,
        }

        struct Request
        {
            public WriteKind Kind;
            public string Path;
            public IntPtr Bytes;
            public long Count;
            public long Offset;
            public RecordPages Pages;
            public Action Call;
            public WriteTicket Ticket;
        }

        readonly Queue<Request> m_requests = new Queue<Request>();
        readonly Thread m_thread;
        readonly Func<Exception> m_check;
        readonly TimeSpan m_checkAfter;
        readonly Action m_stopRetrying;
        volatile bool m_isEnding;
        volatile bool m_isRetryStopped;

        /// <param name="check">Called on the thread before each file and while it waits for one; returns why nothing may be
        /// written any more, or null.</param>
        /// <param name="checkAfter">The longest time between two calls.</param>
        public WriteQueue(Func<Exception> check, TimeSpan checkAfter)
        {
            m_check = check;
            m_checkAfter = checkAfter;
            // The editor is blocked while it waits.
            m_stopRetrying = () => m_isRetryStopped = true;
            m_thread = new Thread(WriteRequests) { IsBackground = true, Name = "FastPoints writer" };
            m_thread.Start();
        }

        public Exception Failure { get; private set; } // The failure, to be read after End; null if there was none.

        /// <summary>Queues a file in one piece. The bytes belong to the queue until the ticket is done, here and below.</summary>
        public WriteTicket Write(string path, NativeArray<byte> bytes) => Enqueue(WriteKind.Whole, path, bytes, 0);

        /// <summary>Queues a piece of a file, which exists when <see cref="Seal"/> is done with it.</summary>
        public WriteTicket WritePiece(string path, NativeArray<byte> bytes, long offset) =>
            Enqueue(WriteKind.Piece, path, bytes, offset);

        /// <summary>Queues the first bytes of a file in pieces, which complete it.</summary>
        public WriteTicket Seal(string path, NativeArray<byte> bytes) => Enqueue(WriteKind.Seal, path, bytes, 0);

        public WriteTicket WriteRecords(string path, in RecordPages pages, long offset) => Enqueue(new Request
        {
            Kind = WriteKind.Records,
            Path = path,
            Pages = pages,
            Offset = offset,
            Ticket = new WriteTicket(m_stopRetrying),
        });

        public WriteTicket Sync(string path) => Enqueue(new Request
        {
            Kind = WriteKind.Sync,
            Path = path,
            Ticket = new WriteTicket(m_stopRetrying),
        });

        public WriteTicket Run(string path, Action act) => Enqueue(new Request
        {
            Kind = WriteKind.Call,
            Path = path,
            Call = act,
            Ticket = new WriteTicket(m_stopRetrying),
        });

        /// <summary>Whether to retry what the system refuses: not while someone waits for the end.</summary>
        public bool ShouldRetry() => !m_isEnding && !m_isRetryStopped;

        /// <summary>Waits for everything queued. May be called twice.</summary>
        public void End()
        {
            lock (m_requests)
            {
                m_isEnding = true;
                Monitor.PulseAll(m_requests);
            }
            m_thread.Join();
        }

        void WriteRequests()
        {
            while (true)
            {
                Request request;
                lock (m_requests)
                {
                    if (m_requests.Count == 0 && !m_isEnding)
                        Monitor.Wait(m_requests, m_checkAfter);
                    if (m_requests.Count == 0 && m_isEnding)
                        return;
                    m_requests.TryDequeue(out request);
                }
                Failure = m_check() ?? Failure;
                if (request.Ticket == null)
                    continue;
                // After a failure nothing more is written: later writes would rely on what is missing.
                try
                {
                    if (Failure == null)
                        FileChanges.Retry(() => Execute(request), ShouldRetry);
                }
                catch (Exception e)
                {
                    // Any exception is caught: if it ended the thread, waiting for the ticket would never end.
                    Failure = FileFailures.IsFileFailure(e)
                        ? FileFailures.WriteFailure(request.Path, e) : PointCloudException.Of(request.Path, e);
                }
                request.Ticket.Finish(Failure);
            }
        }

        WriteTicket Enqueue(WriteKind kind, string path, NativeArray<byte> bytes, long offset) => Enqueue(new Request
        {
            Kind = kind,
            Path = path,
            Bytes = (IntPtr)bytes.GetUnsafeReadOnlyPtr(),
            Count = bytes.Length,
            Offset = offset,
            Ticket = new WriteTicket(m_stopRetrying),
        });

        WriteTicket Enqueue(Request request)
        {
            lock (m_requests)
            {
                m_requests.Enqueue(request);
                Monitor.PulseAll(m_requests);
            }
            return request.Ticket;
        }

        /// <summary>May be repeated after any of its steps.</summary>
        static void Execute(in Request request)
        {
            var bytes = (byte*)request.Bytes;
            string temporary = request.Path + TemporarySuffix;
            switch (request.Kind)
            {
                case WriteKind.Call:
                    request.Call();
                    break;
                case WriteKind.Piece:
                    using (var file = Open(temporary, request.Offset == 0 ? FileMode.Create : FileMode.OpenOrCreate,
                        request.Offset))
                        Write(file, bytes, request.Count);
                    break;
                case WriteKind.Whole:
                case WriteKind.Seal:
                    using (var file = Open(temporary,
                        request.Kind == WriteKind.Whole ? FileMode.Create : FileMode.OpenOrCreate, 0))
                    {
                        Write(file, bytes, request.Count);
                        file.Flush(true);
                    }
                    FileChanges.Replace(temporary, request.Path);
                    break;
                case WriteKind.Sync:
                    using (var file = Open(request.Path, FileMode.Open, 0))
                        file.Flush(true);
                    break;
                default:
                    using (var file = Open(request.Path, FileMode.OpenOrCreate, request.Offset))
                        for (var page = request.Pages.First; page != null; page = page->Next)
                            file.Write(new ReadOnlySpan<byte>(RecordBlock.Of(page), page->BlockBytes));
                    break;
            }
        }

        static FileStream Open(string path, FileMode mode, long offset)
        {
            var file = FileChanges.OpenToWrite(path, mode);
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
    }

    internal sealed class WriteTicket
    {
        readonly object m_lock = new object();
        readonly Action m_stopRetrying;
        bool m_isDone;
        Exception m_failure;

        public WriteTicket(Action stopRetrying) => m_stopRetrying = stopRetrying;

        /// <summary>Whether the file is complete on disk; waits at most this long for it.</summary>
        /// <exception cref="FastPoints.PointCloudException">It could not be written.</exception>
        public bool IsDone(int waitMs)
        {
            lock (m_lock)
            {
                if (!m_isDone && waitMs > 0)
                    Monitor.Wait(m_lock, waitMs);
                if (m_failure != null)
                    throw m_failure;
                return m_isDone;
            }
        }

        /// <summary>Waits until the bytes are no longer needed, written or not; throws nothing, for clean-up.</summary>
        public void WaitAndStopRetries()
        {
            lock (m_lock)
            {
                if (!m_isDone)
                    m_stopRetrying();
                while (!m_isDone)
                    Monitor.Wait(m_lock);
            }
        }

        internal void Finish(Exception failure)
        {
            lock (m_lock)
            {
                m_failure = failure;
                m_isDone = true;
                Monitor.PulseAll(m_lock);
            }
        }
    }
}
