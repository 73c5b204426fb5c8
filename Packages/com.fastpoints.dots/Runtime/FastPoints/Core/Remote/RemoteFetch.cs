using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints
{
    // Pieces of remote files, on their way or here. Whoever disposes it has completed the jobs that copy from it.
    internal sealed unsafe class RemoteFetch : IDisposable
    {
        const int MaxHeadBytes = 1 << 20; // A node of an octree of many files mostly comes with opening its file.

        const long MaxWholeBytes = 1L << 28;

        sealed class Fetch
        {
            public FilePiece Piece;
            public PoolTask<RemoteFile> Opening;
            public RemoteFile File;
            public RemoteRead Read;
            public bool IsWhole;
            public bool IsOpenedHere;
        }

        readonly List<Fetch> m_fetches = new List<Fetch>();
        readonly int m_rank;

        // A piece without a length is its whole file. What has the lowest rank is fetched first. Nothing waits.
        public RemoteFetch(List<FilePiece> pieces, int rank)
        {
            m_rank = rank;
            foreach (var piece in pieces)
            {
                var file = piece.Remote ?? RemoteFile.Find(piece.Path);
                var fetch = new Fetch { Piece = piece, IsWhole = piece.LengthBytes < 0, File = file };
                m_fetches.Add(fetch);
                if (fetch.File != null)
                    Begin(fetch);
                else
                    fetch.Opening = PoolTask.Begin(SourcePath.WithoutQuery(piece.Path),
                        () => RemoteFile.Open(piece.Path, HeadBytesFor(piece)), file => file.DropOpened());
            }
        }

        static int HeadBytesFor(FilePiece piece)
        {
            long end = piece.LengthBytes < 0 ? MaxHeadBytes : piece.OffsetBytes + piece.LengthBytes;
            return end > MaxHeadBytes ? RemoteFile.HeadBytes : (int)Math.Max(end, RemoteFile.HeadBytes);
        }

        public PointCloudException Failure { get; private set; } // Of the first piece that failed, once all are done.

        // Of all pieces; a whole file counts once it is opened.
        public long Bytes
        {
            get
            {
                long bytes = 0;
                foreach (var fetch in m_fetches)
                    bytes += Math.Max(0, fetch.Piece.LengthBytes);
                return bytes;
            }
        }

        // Begins the reads of files that were opened meanwhile.
        public bool PollIsDone()
        {
            bool isDone = true;
            foreach (var fetch in m_fetches)
                isDone &= Poll(fetch);
            return isDone;
        }

        bool Poll(Fetch fetch)
        {
            if (fetch.Opening != null)
            {
                if (!fetch.Opening.IsDone)
                    return false;
                var opening = fetch.Opening;
                fetch.Opening = null;
                try
                {
                    fetch.File = opening.Take();
                    fetch.IsOpenedHere = true;
                    Begin(fetch);
                }
                catch (PointCloudException failure)
                {
                    Failure ??= failure;
                }
            }
            if (fetch.Read == null)
                return true;
            if (!fetch.Read.IsDone)
                return false;
            Failure ??= fetch.Read.Failure;
            return true;
        }

        void Begin(Fetch fetch)
        {
            long left = fetch.File.Length - fetch.Piece.OffsetBytes;
            // What lies behind the file's end is the reader's business.
            fetch.Piece.LengthBytes = fetch.IsWhole ? left : Math.Min(fetch.Piece.LengthBytes, left);
            if (fetch.IsWhole && left > MaxWholeBytes)
                Failure ??= PointCloudException.Wanted(FailureCode.Unsupported, fetch.Piece.Path, -1,
                    "bytes of a file that is read whole", "at most " + NumberText.Of(MaxWholeBytes), NumberText.Of(left));
            else if (fetch.Piece.LengthBytes > 0)
                fetch.Read = fetch.File.Begin(fetch.Piece.OffsetBytes, fetch.Piece.LengthBytes, m_rank);
        }

        // Schedules jobs that copy what a command wants. False if not all of it is here.
        public bool TryCopy(string path, in ReadCommand command, ref JobHandle copied)
        {
            long end = command.Offset + command.Size;
            for (long at = command.Offset; at < end;)
            {
                var fetch = FindFetched(path, at);
                if (fetch == null)
                    return false;
                long first = at - fetch.Piece.OffsetBytes, bytes = Math.Min(end - at, fetch.Piece.LengthBytes - first);
                copied = JobHandle.CombineDependencies(copied, new CopyFetchedJob
                {
                    From = fetch.Read.Data + first,
                    To = (byte*)command.Buffer + (at - command.Offset),
                    Bytes = bytes,
                }.Schedule());
                at += bytes;
            }
            return true;
        }

        Fetch FindFetched(string path, long offset) => m_fetches.Find(fetch => fetch.Piece.Path == path
            && fetch.Piece.OffsetBytes <= offset && offset < fetch.Piece.OffsetBytes + fetch.Piece.LengthBytes
            && fetch.Read != null && fetch.Read.IsDone && fetch.Read.Failure == null);

        // Cancels what has not come.
        public void Dispose()
        {
            foreach (var fetch in m_fetches)
            {
                // There may be as many files as nodes.
                if (fetch.IsOpenedHere)
                    fetch.File.DropOpened();
                fetch.Opening?.Dispose();
                fetch.Read?.Dispose();
            }
            m_fetches.Clear();
        }
    }

    // Fetches of remote files what the next reads need, several at once and in their order, so that none waits. Main thread.
    internal sealed class FetchWindow : IDisposable
    {
        // Bytes in flight or fetched and not taken; one read is always begun, however long. At 100 Mbit/s they take a second.
        const long MaxBytes = 12 << 20;
        const int MaxReads = 32; // Servers answer some at a time; the others wait here for connections.

        readonly Action<int, List<FilePiece>> m_listPieces;
        readonly int m_end;
        readonly Queue<RemoteFetch> m_begun = new Queue<RemoteFetch>();
        readonly List<FilePiece> m_pieces = new List<FilePiece>();
        int m_next;

        // Reads from first to before end; listPieces adds the pieces of one of them.
        public FetchWindow(int first, int end, Action<int, List<FilePiece>> listPieces)
        {
            m_next = first;
            m_end = end;
            m_listPieces = listPieces;
        }

        // Begins the next reads; whether the first of them can be taken.
        public bool TryPrepareNext()
        {
            while (m_next < m_end && m_begun.Count < MaxReads && BytesBegun < MaxBytes)
                Begin(m_next++);
            return m_begun.Count == 0 || m_begun.Peek().PollIsDone();
        }

        long BytesBegun
        {
            get
            {
                long bytes = 0;
                foreach (var fetched in m_begun)
                    bytes += fetched.Bytes;
                return bytes;
            }
        }

        // What the next read needs. The receiver owns it.
        public RemoteFetch Take() => m_begun.Count > 0 ? m_begun.Dequeue() : null;

        void Begin(int read)
        {
            m_pieces.Clear();
            m_listPieces(read, m_pieces);
            m_begun.Enqueue(new RemoteFetch(m_pieces, read));
        }

        public void Dispose()
        {
            foreach (var fetched in m_begun)
                fetched.Dispose();
            m_begun.Clear();
        }
    }

    [BurstCompile]
    unsafe struct CopyFetchedJob : IJob
    {
        [NativeDisableUnsafePtrRestriction] public byte* From;
        [NativeDisableUnsafePtrRestriction] public byte* To;
        public long Bytes;

        public void Execute() => UnsafeUtility.MemCpy(To, From, Bytes);
    }
}
