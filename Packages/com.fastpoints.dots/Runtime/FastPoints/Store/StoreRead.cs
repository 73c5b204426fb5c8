using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Store
{
    // Reads consecutive bytes of a file in the background, into memory of its own that is reused from read to read.
    internal sealed unsafe class StoreRead : IDisposable
    {
        // The read manager keeps the pointer to its command until the read has ended.
        NativeArray<ReadCommand> m_command = new NativeArray<ReadCommand>(1, Allocator.Persistent);
        NativeArray<byte> m_bytes;
        ReadHandle m_read;
        bool m_isReading;
        string m_path;
        int m_count;

        public NativeArray<byte> Bytes => m_bytes.GetSubArray(0, m_count);

        public JobHandle Done { get; private set; }

        public void Begin(string path, long offset, long count)
        {
            if (count > int.MaxValue)
                throw PointCloudException.Wanted(FailureCode.Unsupported, path, offset, "bytes at once", "at most 2 GiB", count);
            m_path = path;
            m_count = (int)count;
            if (!m_bytes.IsCreated || m_bytes.Length < m_count)
            {
                if (m_bytes.IsCreated)
                    m_bytes.Dispose();
                m_bytes = new NativeArray<byte>(Math.Max(16, m_count), Allocator.Persistent,
                    NativeArrayOptions.UninitializedMemory);
            }
            m_command[0] = new ReadCommand { Buffer = m_bytes.GetUnsafePtr(), Offset = offset, Size = m_count };
            m_read = FileReads.BeginOneShot(path, (ReadCommand*)m_command.GetUnsafePtr(), 1);
            m_isReading = true;
            Done = m_read.JobHandle;
        }

        // Throws if not all of it could be read.
        public void Complete()
        {
            Done.Complete();
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
