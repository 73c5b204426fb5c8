using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints
{
    // Some bytes of a remote file, on their way to memory. Any thread may ask whether they have come; nothing waits. After Cancel
    // no more is written: its memory may be freed at once.
    internal sealed unsafe class RemoteRead : IDisposable
    {
        readonly object m_lock = new object();
        readonly ReadCommand[] m_parts;
        byte* m_owned;
        int m_waitingParts;
        bool m_isCancelled;
        volatile bool m_isDone;
        PointCloudException m_failure;

        // Into memory of the caller, which lives until the read is done or cancelled.
        internal RemoteRead(RemoteFile file, ReadCommand* parts, int count, int rank)
        {
            File = file;
            Rank = rank;
            m_parts = new ReadCommand[count];
            for (int i = 0; i < count; i++)
                m_parts[i] = parts[i];
            m_waitingParts = count;
        }

        // Into memory of its own.
        internal RemoteRead(RemoteFile file, long offset, long bytes, int rank)
        {
            File = file;
            Rank = rank;
            m_owned = (byte*)UnsafeUtility.Malloc(Math.Max(1, bytes), 16, Allocator.Persistent);
            m_parts = new[] { new ReadCommand { Buffer = m_owned, Offset = offset, Size = bytes } };
            m_waitingParts = 1;
        }

        public RemoteFile File { get; }

        // What has the lowest rank is fetched first.
        public int Rank { get; }

        public bool IsDone => m_isDone;
        public bool IsCancelled => m_isCancelled;

        // Once it is done: null if all bytes have come.
        public PointCloudException Failure => m_failure;

        public long Offset => m_parts[0].Offset;
        public long Bytes => m_parts[0].Size;

        // Of a read into memory of its own, once it is done: until Dispose.
        public byte* Data => m_owned;

        internal ReadOnlySpan<ReadCommand> Parts => m_parts;

        public void Cancel()
        {
            lock (m_lock)
            {
                m_isCancelled = true;
                m_isDone = true;
            }
        }

        public void Dispose()
        {
            Cancel();
            if (m_owned != null)
                UnsafeUtility.Free(m_owned, Allocator.Persistent);
            m_owned = null;
        }

        // Takes one whole part. On the thread that has fetched it.
        internal void Take(int part, ReadOnlySpan<byte> bytes)
        {
            lock (m_lock)
            {
                if (m_isDone)
                    return;
                bytes.CopyTo(new Span<byte>(m_parts[part].Buffer, checked((int)m_parts[part].Size)));
                m_isDone = --m_waitingParts == 0;
            }
        }

        internal void Fail(PointCloudException failure)
        {
            lock (m_lock)
            {
                if (m_isDone)
                    return;
                m_failure = failure;
                m_isDone = true;
            }
        }
    }
}
