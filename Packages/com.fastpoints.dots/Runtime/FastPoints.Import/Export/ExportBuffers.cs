using System;
using System.Collections.Generic;
using FastPoints.Build;
using FastPoints.Laz;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Export
{
    /// <summary>The records on their way to the file: a ring of buffers that jobs fill one after another, and that are written,
    /// in that order, by a thread of their own. The file gets its name when it is whole.</summary>
    internal sealed unsafe class ExportBuffers : IDisposable
    {
        const int SpareBuffers = 3; // Buffers that are filled or written while others are compressed.

        readonly string m_path;
        readonly ExportFormat m_format;
        readonly Buffer[] m_buffers;
        readonly WriteQueue m_queue = new WriteQueue(() => null, TimeSpan.FromSeconds(1));
        NativeArray<ulong> m_pointers;
        long m_sealed;
        long m_queued;
        long m_written;
        bool m_isWhole;

        struct Buffer
        {
            public NativeArray<byte> Records;
            public int Points;
            public int FreePoints; // Room that the buffer's node leaves free.
            public LazChunkWriter Writer; // Made when it is first needed; null for records as they are.
            public JobHandle Compressed;
            public WriteTicket Ticket;
        }

        /// <param name="maxPoints">The most points that are appended at once.</param>
        /// <param name="parallel">The number of buffers that are compressed side by side.</param>
        public ExportBuffers(string path, ExportFormat format, int maxPoints, int parallel)
        {
            m_path = path;
            m_format = format;
            m_buffers = new Buffer[maxPoints / format.BufferPoints + parallel + SpareBuffers];
            m_pointers = new NativeArray<ulong>(m_buffers.Length, Allocator.Persistent);
            for (int i = 0; i < m_buffers.Length; i++)
            {
                m_buffers[i].Records = new NativeArray<byte>(format.BufferPoints * format.RecordBytes, Allocator.Persistent,
                    NativeArrayOptions.UninitializedMemory);
                m_pointers[i] = (ulong)m_buffers[i].Records.GetUnsafePtr();
            }
        }

        public NativeArray<ulong> Pointers => m_pointers;

        public long Bytes { get; private set; } // Bytes that are written, or wait to be.

        /// <summary>Whether records up to this one have free buffers.</summary>
        public bool HasRoom(long end) =>
            end <= (m_written + m_buffers.Length) * m_format.BufferPoints;

        /// <summary>Ends a node, whose buffer has its number, before the buffer is full.</summary>
        /// <returns>The record up to which the buffers count as filled.</returns>
        public long EndNode(int node, long filled)
        {
            long end = (node + 1L) * m_format.BufferPoints;
            At(node).FreePoints = (int)(end - filled);
            return end;
        }

        /// <summary>The jobs of the oldest buffer that is not written; complete ones if there is none.</summary>
        public JobHandle OldestJobs => m_queued < m_sealed ? At(m_queued).Compressed : default;

        /// <summary>Moves each buffer on as far as it can: from filled by jobs to compressed, written and free
        /// again.</summary>
        /// <param name="waitMs">How long to wait for the disk if it is all that is to be waited for.</param>
        public void Advance(long filled, int waitMs)
        {
            for (; (m_sealed + 1) * m_format.BufferPoints <= filled; m_sealed++)
                Seal(m_sealed, m_format.BufferPoints - At(m_sealed).FreePoints);
            for (; m_queued < m_sealed && At(m_queued).Compressed.IsCompleted; m_queued++)
                At(m_queued).Ticket = Append(BytesOf(ref At(m_queued)));
            for (; m_written < m_queued && At(m_written).Ticket.IsDone(waitMs); m_written++)
                waitMs = 0;
        }

        /// <summary>Coroutine, after all jobs: writes the last points, and awaits all writes.</summary>
        public IEnumerator<JobStep> Drain(long filled)
        {
            Advance(filled, 0);
            int rest = (int)(filled - m_sealed * m_format.BufferPoints);
            if (rest > 0)
                Seal(m_sealed++, rest);
            while (m_written < m_sealed)
            {
                yield return OldestJobs;
                Advance(filled, 1);
            }
        }

        public WriteTicket Append(NativeArray<byte> bytes)
        {
            var ticket = m_queue.WritePiece(m_path, bytes, Bytes);
            Bytes += bytes.Length;
            return ticket;
        }

        /// <summary>Coroutine: writes bytes behind all others, or, as the last ones, over the first.</summary>
        public IEnumerator<JobStep> Write(byte[] bytes, bool isLast)
        {
            using var copy = new NativeArray<byte>(bytes, Allocator.Persistent);
            yield return JobStep.Of(CloudFolderWriter.Await(isLast ? m_queue.Seal(m_path, copy) : Append(copy)));
            m_isWhole |= isLast;
        }

        /// <summary>If the file is not whole, nothing is left of it.</summary>
        public void Dispose()
        {
            if (!m_pointers.IsCreated)
                return;
            m_queue.End();
            foreach (var buffer in m_buffers)
            {
                buffer.Compressed.Complete();
                buffer.Writer?.Dispose();
                buffer.Records.Dispose();
            }
            m_pointers.Dispose();
            // The failure that led here is the one to report.
            if (!m_isWhole)
                FileChanges.TryDelete(m_path + WriteQueue.TemporarySuffix, () => false);
        }

        void Seal(long number, int points)
        {
            ref var buffer = ref At(number);
            buffer.Points = points;
            buffer.Writer ??= m_format.CreateWriter();
            buffer.Compressed = buffer.Writer == null || points == 0 ? default : buffer.Writer.Schedule(buffer.Records, points);
            JobHandle.ScheduleBatchedJobs();
        }

        NativeArray<byte> BytesOf(ref Buffer buffer)
        {
            buffer.Compressed.Complete();
            var bytes = buffer.Points > 0 && buffer.Writer != null ? buffer.Writer.Chunk
                : buffer.Records.GetSubArray(0, buffer.Points * m_format.RecordBytes);
            m_format.OnBufferWritten(bytes.Length, buffer.Points);
            return bytes;
        }

        ref Buffer At(long number) => ref m_buffers[number % m_buffers.Length];
    }
}
