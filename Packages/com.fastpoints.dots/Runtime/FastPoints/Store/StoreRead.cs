using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Store
{
    // Reads consecutive bytes of a file in the background, into memory of its own that is reused from read to read. Jobs
    // that depend on Done may use them; of a remote file only once IsFetched is true (until then Done covers nothing).
    internal sealed unsafe class StoreRead : IDisposable
    {
        // The read manager keeps the pointer to its command until the read has ended.
        NativeArray<ReadCommand> m_command = new NativeArray<ReadCommand>(1, Allocator.Persistent);
        NativeArray<byte> m_bytes;
        ReadHandle m_read;
        bool m_isReading;
        RemoteRead m_remote;
        string m_path;
        int m_count;

        public NativeArray<byte> Bytes => m_bytes.GetSubArray(0, m_count);

        public JobHandle Done { get; private set; }

        public bool IsFetched => m_remote == null || m_remote.IsDone; // Whether jobs that depend on Done may be scheduled.

        // remote: the file, if it is on a web server.
        public void Begin(string path, long offset, long count, RemoteFile remote = null)
        {
            Reserve(path, offset, count);
            m_command[0] = new ReadCommand { Buffer = m_bytes.GetUnsafePtr(), Offset = offset, Size = m_count };
            Done = default;
            m_remote = remote?.Begin((ReadCommand*)m_command.GetUnsafePtr(), 1);
            if (remote != null)
                return;
            m_read = FileReads.BeginOneShot(path, (ReadCommand*)m_command.GetUnsafePtr(), 1);
            m_isReading = true;
            Done = m_read.JobHandle;
        }

        // Only some of the bytes, of a remote file; the others are undefined.
        public void Begin(RemoteFile remote, long offset, long count, List<PlaneRange> pieces)
        {
            Reserve(remote.Name, offset, count);
            pieces.Sort((a, b) => a.OffsetBytes.CompareTo(b.OffsetBytes));
            using var commands = new NativeList<ReadCommand>(pieces.Count, Allocator.Persistent);
            long end = -1;
            foreach (var piece in pieces)
            {
                long begin = Math.Max(end, piece.OffsetBytes), pieceEnd = piece.OffsetBytes + piece.LengthBytes;
                if (pieceEnd <= begin)
                    continue;
                if (begin != end)
                    commands.Add(new ReadCommand { Buffer = (byte*)m_bytes.GetUnsafePtr() + (begin - offset), Offset = begin });
                commands.ElementAt(commands.Length - 1).Size += pieceEnd - begin;
                end = pieceEnd;
            }
            Done = default;
            m_remote = remote.Begin(commands.GetUnsafePtr(), commands.Length);
        }

        void Reserve(string path, long offset, long count)
        {
            if (count > int.MaxValue)
                throw PointCloudException.Wanted(FailureCode.Unsupported, path, offset, "bytes at once", "at most 2 GiB", count);
            m_path = path;
            m_count = (int)count;
            if (m_bytes.IsCreated && m_bytes.Length >= m_count)
                return;
            if (m_bytes.IsCreated)
                m_bytes.Dispose();
            m_bytes = new NativeArray<byte>(Math.Max(16, m_count), Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        }

        // Throws if not all of it could be read.
        public void Complete()
        {
            Done.Complete();
            var failure = m_remote?.Failure;
            m_remote = null;
            if (failure != null)
                throw failure;
            if (!m_isReading)
                return;
            m_isReading = false;
            var status = m_read.Status;
            m_read.Dispose();
            if (status != ReadStatus.Complete)
                throw new PointCloudException(status == ReadStatus.Truncated ? FailureCode.Truncated : FailureCode.ReadFailed,
                    m_path,
                    m_command[0].Offset, "wanted " + m_count + " bytes, the read ended as " + status);
        }

        // Awaits the read, whatever its result; jobs that depend on it must be complete.
        public void Abandon()
        {
            m_remote?.Cancel();
            m_remote = null;
            if (!m_isReading)
                return;
            m_read.Cancel();
            Done.Complete();
            m_read.Dispose();
            m_isReading = false;
        }

        public void Dispose()
        {
            if (!m_command.IsCreated)
                return;
            Abandon();
            if (m_bytes.IsCreated)
                m_bytes.Dispose();
            m_command.Dispose();
        }
    }
}
