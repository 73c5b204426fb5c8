using System;
using System.Collections.Generic;

namespace FastPoints
{
    // Fetches of remote files what the next reads need, several at once and in their order, so that none waits. Main thread.
    internal sealed class FetchWindow : IDisposable
    {
        // Bytes in flight or fetched and not taken; one read is always begun, however long. At 100 Mbit/s they take a second.
        const long MaxBytes = 12 << 20;

        // Servers answer some at a time; the others wait here for connections.
        const int MaxReads = 32;

        readonly Action<int, List<FilePiece>> m_listPieces;
        readonly int m_end;
        readonly Queue<FetchedBytes> m_begun = new Queue<FetchedBytes>();
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
            return m_begun.Count == 0 || m_begun.Peek().IsDone;
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
        public FetchedBytes Take() => m_begun.Count > 0 ? m_begun.Dequeue() : null;

        void Begin(int read)
        {
            m_pieces.Clear();
            m_listPieces(read, m_pieces);
            m_begun.Enqueue(new FetchedBytes(m_pieces, read));
        }

        public void Dispose()
        {
            foreach (var fetched in m_begun)
                fetched.Dispose();
            m_begun.Clear();
        }
    }
}
