using System;
using FastPoints.Base;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Reads one stretch of a file into native memory: at most one read is in flight, into a buffer that is
    /// reused.</summary>
    sealed unsafe class NativeFileRead : IDisposable
    {
        /// <summary>Bytes behind the data that jobs may overwrite with an end mark, or load and ignore.</summary>
        public const int PaddingBytes = 16;

        string m_path;
        readonly FileHandle m_file;
        readonly Allocator m_allocator;
        NativeArray<byte> m_buffer;
        NativeArray<ReadCommand> m_command;
        ReadHandle m_handle;
        bool m_isReading;

        public NativeFileRead(string path, FileHandle file, long capacityBytes, Allocator allocator)
        {
            m_path = path;
            m_file = file;
            m_allocator = allocator;
            Reserve(capacityBytes);
            m_command = new NativeArray<ReadCommand>(1, allocator);
        }

        /// <summary>Makes room for so many bytes; what is in the buffer is lost. There is no read in flight.</summary>
        public void Reserve(long capacityBytes)
        {
            if (capacityBytes > int.MaxValue - PaddingBytes)
                throw new ArgumentOutOfRangeException(nameof(capacityBytes), capacityBytes, "a read holds less than 2 GiB");
            int bytes = (int)capacityBytes + PaddingBytes;
            if (bytes <= m_buffer.Length)
                return;
            if (m_buffer.IsCreated)
                m_buffer.Dispose();
            m_buffer = new NativeArray<byte>(bytes, m_allocator, NativeArrayOptions.UninitializedMemory);
        }

        /// <summary>The bytes, valid after the handle that <see cref="Begin"/> gives.</summary>
        public NativeArray<byte> Buffer => m_buffer;

        public long Offset { get; private set; }
        public int Bytes { get; private set; }

        public JobHandle Begin(long offset, int bytes) => Begin(m_file, offset, bytes);

        /// <summary>The same from another open file.</summary>
        public JobHandle Begin(in FileHandle file, long offset, int bytes)
        {
            if (!Prepare(offset, bytes))
                return default;
            var commands = new ReadCommandArray
            {
                ReadCommands = (ReadCommand*)m_command.GetUnsafePtr(),
                CommandCount = 1,
            };
            m_handle = AsyncReadManager.Read(file, commands);
            m_isReading = true;
            return m_handle.JobHandle;
        }

        /// <summary>The same from a file of its own, which is opened and closed for it.</summary>
        /// <param name="path">An absolute path.</param>
        public JobHandle Begin(string path, long offset, int bytes)
        {
            m_path = path;
            if (!Prepare(offset, bytes))
                return default;
            m_handle = AsyncReadManager.Read(path, (ReadCommand*)m_command.GetUnsafePtr(), 1);
            m_isReading = true;
            return m_handle.JobHandle;
        }

        bool Prepare(long offset, int bytes)
        {
            Offset = offset;
            Bytes = bytes;
            m_command[0] = new ReadCommand { Buffer = m_buffer.GetUnsafePtr(), Offset = offset, Size = bytes };
            return bytes > 0;
        }

        /// <summary>Closes a read that is finished.</summary>
        /// <exception cref="PointCloudException">It failed, or the file has become shorter since it was opened.</exception>
        public void End()
        {
            var status = Close(out _);
            if (status == ReadStatus.Complete)
                return;
            throw new PointCloudException(FailureCode.ReadFailed, m_path, Offset, status == ReadStatus.Truncated
                ? "the file ended within " + Bytes + " bytes that were there when it was opened"
                : "reading " + Bytes + " bytes failed");
        }

        /// <summary>Closes a read that is finished, and says how it ended.</summary>
        /// <param name="got">Bytes that came.</param>
        public ReadStatus Close(out long got)
        {
            got = Bytes;
            if (!m_isReading)
                return ReadStatus.Complete;
            m_isReading = false;
            m_handle.JobHandle.Complete();
            var status = m_handle.Status;
            if (status != ReadStatus.Complete)
                got = m_handle.GetBytesRead();
            m_handle.Dispose();
            return status;
        }

        /// <summary>Asks a read in flight to stop early; it stays open.</summary>
        public void Cancel()
        {
            if (m_isReading)
                m_handle.Cancel();
        }

        /// <summary>Jobs that use the buffer must be complete.</summary>
        public void Dispose()
        {
            Cancel();
            Close(out _);
            if (m_buffer.IsCreated)
                m_buffer.Dispose();
            if (m_command.IsCreated)
                m_command.Dispose();
        }
    }
}
