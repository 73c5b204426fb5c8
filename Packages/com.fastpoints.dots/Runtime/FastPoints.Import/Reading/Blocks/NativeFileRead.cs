using System;
using FastPoints.Core;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Reading
{
    /// <summary>Reads one segment of a file into native memory, or several with one request: at most one is in flight, into a
    /// buffer that is reused.</summary>
    sealed unsafe class NativeFileRead : IDisposable
    {
        /// <summary>Bytes behind the data that jobs may overwrite with an end mark, or load and ignore.</summary>
        public const int PaddingBytes = 16;

        readonly Allocator m_allocator;
        NativeArray<byte> m_buffer;
        // The read manager keeps the pointer to its commands until the read has ended.
        NativeArray<ReadCommand> m_commands;
        ReadHandle m_handle;
        string m_path;
        bool m_isReading;

        /// <param name="segments">The most segments of one request.</param>
        public NativeFileRead(long capacityBytes, Allocator allocator, int segments = 1)
        {
            m_allocator = allocator;
            Reserve(capacityBytes);
            m_commands = new NativeArray<ReadCommand>(Math.Max(1, segments), allocator);
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

        /// <summary>The bytes, valid after the handle that <see cref="Begin(SourceHandle, int)"/> gives.</summary>
        public NativeArray<byte> Buffer => m_buffer;

        /// <summary>For several segments: where each lies in the file and goes in the buffer.</summary>
        public NativeArray<ReadCommand> Commands => m_commands;

        /// <summary>Of the first segment.</summary>
        public long Offset => m_commands[0].Offset;

        /// <summary>Of the first segment.</summary>
        public int Bytes => (int)m_commands[0].Size;

        public bool IsReading => m_isReading;

        public JobHandle Begin(SourceHandle file, long offset, int bytes)
        {
            m_commands[0] = new ReadCommand { Buffer = m_buffer.GetUnsafePtr(), Offset = offset, Size = bytes };
            return bytes > 0 ? Begin(file, 1) : default;
        }

        /// <summary>Begins the first of <see cref="Commands"/>.</summary>
        public JobHandle Begin(SourceHandle file, int commands)
        {
            m_path = file.Path;
            m_handle = AsyncReadManager.Read(file.Open(), new ReadCommandArray
            {
                ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(),
                CommandCount = commands,
            });
            m_isReading = true;
            return m_handle.JobHandle;
        }

        /// <summary>Reads from a file that is opened and closed for it.</summary>
        /// <param name="path">An absolute path.</param>
        public JobHandle Begin(string path, long offset, int bytes)
        {
            m_path = path;
            m_commands[0] = new ReadCommand { Buffer = m_buffer.GetUnsafePtr(), Offset = offset, Size = bytes };
            if (bytes <= 0)
                return default;
            m_handle = FileReads.BeginOneShot(path, (ReadCommand*)m_commands.GetUnsafePtr(), 1);
            m_isReading = true;
            return m_handle.JobHandle;
        }

        /// <summary>Closes a read that is finished.</summary>
        /// <exception cref="PointCloudException">It failed, or the file has become shorter since it was opened.</exception>
        public void End()
        {
            var status = Close(out _);
            if (status != ReadStatus.Complete)
                throw new PointCloudException(FailureCode.ReadFailed, m_path, Offset, status == ReadStatus.Truncated
                    ? "the file has become shorter since it was opened" : "the file could not be read");
        }

        /// <summary>Closes a read that is finished, and says how it ended.</summary>
        /// <param name="got">Bytes of a single segment that came.</param>
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

        /// <summary>Jobs that use the buffer must be complete. May be called twice.</summary>
        public void Dispose()
        {
            if (!m_buffer.IsCreated)
                return;
            Cancel();
            Close(out _);
            m_buffer.Dispose();
            m_commands.Dispose();
        }
    }
}
