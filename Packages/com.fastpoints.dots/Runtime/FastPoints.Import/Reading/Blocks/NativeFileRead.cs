using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Reading
{
    // One segment of a file, or several with one request: at most one is in flight, into a buffer that is reused.
    sealed unsafe class NativeFileRead : IDisposable
    {
        public const int PaddingBytes = 16; // Bytes behind the data that jobs may overwrite with an end mark, or load and ignore.

        readonly Allocator m_allocator;
        NativeArray<byte> m_buffer;
        // The read manager keeps the pointer to its commands until the read has ended.
        NativeArray<ReadCommand> m_commands;
        ReadHandle m_handle;
        string m_path;
        RemoteFetch m_fetched;
        JobHandle m_copied;
        PointCloudException m_failure;

        public NativeFileRead(long capacityBytes, Allocator allocator, int segments = 1)
        {
            m_allocator = allocator;
            Reserve(capacityBytes);
            m_commands = new NativeArray<ReadCommand>(Math.Max(1, segments), allocator);
        }

        // Discards the buffer's content. No read may be in flight.
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

        public NativeArray<byte> Buffer => m_buffer;
        public NativeArray<ReadCommand> Commands => m_commands;
        public long Offset => m_commands[0].Offset;
        public int Bytes => (int)m_commands[0].Size;
        public bool IsReading { get; private set; }

        // What the next read of remote files needs. Freed when that has ended.
        public RemoteFetch Fetched
        {
            set
            {
                m_fetched?.Dispose();
                m_fetched = value;
            }
        }

        // Returns whether what is read next is here: of a local file always. Of a remote one the first call begins the requests.
        public bool TryFetch(string path, long offset, long bytes)
        {
            if (!SourcePath.IsRemote(path))
                return true;
            m_commands[0] = new ReadCommand { Offset = offset, Size = bytes };
            return TryFetch(path, 1);
        }

        // The same of several segments, which are set.
        public bool TryFetch(string path, int commands)
        {
            if (!SourcePath.IsRemote(path))
                return true;
            if (m_fetched == null)
            {
                var pieces = new List<FilePiece>();
                for (int i = 0; i < commands; i++)
                    pieces.Add(new FilePiece
                    {
                        Path = path,
                        OffsetBytes = m_commands[i].Offset,
                        LengthBytes = m_commands[i].Size,
                    });
                m_fetched = new RemoteFetch(pieces, 0);
            }
            return m_fetched.PollIsDone();
        }

        // Of a whole remote file.
        public long FetchedLength(string path) => m_fetched?.Bytes ?? (RemoteFile.Find(path) ?? RemoteFile.Open(path)).Length;

        public JobHandle Begin(SourceHandle file, long offset, int bytes)
        {
            m_commands[0] = new ReadCommand { Buffer = m_buffer.GetUnsafePtr(), Offset = offset, Size = bytes };
            return bytes > 0 ? Begin(file, 1) : default;
        }

        public JobHandle Begin(SourceHandle file, int commands)
        {
            m_path = file.Path;
            if (file.IsRemote)
                return CopyFetched(commands);
            m_handle = AsyncReadManager.Read(file.Open(), new ReadCommandArray
            {
                ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(),
                CommandCount = commands,
            });
            IsReading = true;
            return m_handle.JobHandle;
        }

        // The file is opened and closed for it; the path is absolute.
        public JobHandle Begin(string path, long offset, int bytes)
        {
            m_commands[0] = new ReadCommand { Buffer = m_buffer.GetUnsafePtr(), Offset = offset, Size = bytes };
            return Begin(path, bytes > 0 ? 1 : 0);
        }

        // The same of several segments, which are set.
        public JobHandle Begin(string path, int commands)
        {
            m_path = path;
            if (SourcePath.IsRemote(path))
                return CopyFetched(commands);
            if (commands == 0)
                return default;
            m_handle = FileReads.BeginOneShot(path, (ReadCommand*)m_commands.GetUnsafePtr(), commands);
            IsReading = true;
            return m_handle.JobHandle;
        }

        // What nobody has fetched is waited for.
        JobHandle CopyFetched(int commands)
        {
            IsReading = true;
            m_failure = m_fetched?.Failure;
            try
            {
                for (int i = 0; i < commands && m_failure == null; i++)
                    if (m_fetched == null || !m_fetched.TryCopy(m_path, m_commands[i], ref m_copied))
                        ReadNow(m_commands[i]);
            }
            catch (PointCloudException failure)
            {
                m_failure = failure;
            }
            return m_copied;
        }

        void ReadNow(ReadCommand command)
        {
            RemoteStatistics.AddWait();
            var file = RemoteFile.Find(m_path) ?? RemoteFile.Open(m_path);
            file.Read(command.Offset, new Span<byte>(command.Buffer, checked((int)command.Size)));
        }

        public void End()
        {
            var status = Close(out _);
            if (status != ReadStatus.Complete)
                throw new PointCloudException(FailureCode.ReadFailed, m_path, Offset, status == ReadStatus.Truncated
                    ? "the file has become shorter since it was opened" : "the file could not be read");
        }

        public ReadStatus Close(out long got)
        {
            got = Bytes;
            if (!IsReading)
                return ReadStatus.Complete;
            IsReading = false;
            if (SourcePath.IsRemote(m_path))
                return EndCopying();
            m_handle.JobHandle.Complete();
            var status = m_handle.Status;
            if (status != ReadStatus.Complete)
                got = m_handle.GetBytesRead();
            m_handle.Dispose();
            return status;
        }

        ReadStatus EndCopying()
        {
            m_copied.Complete();
            m_copied = default;
            Fetched = null;
            var failure = m_failure;
            m_failure = null;
            return failure == null ? ReadStatus.Complete : throw failure;
        }

        public void Cancel()
        {
            if (IsReading && !SourcePath.IsRemote(m_path))
                m_handle.Cancel();
        }

        public void Dispose()
        {
            if (!m_buffer.IsCreated)
                return;
            Cancel();
            m_failure = null;
            Close(out _);
            Fetched = null;
            m_buffer.Dispose();
            m_commands.Dispose();
        }
    }

    // Opened at the first read: pool threads open readers, but handles belong to the main thread.
    sealed class SourceHandle
    {
        FileHandle m_handle;
        bool m_isOpen;

        public SourceHandle(string path) => Path = path;

        public string Path { get; }

        public bool IsRemote => SourcePath.IsRemote(Path);

        public ref readonly FileHandle Open()
        {
            if (!m_isOpen)
                m_handle = AsyncReadManager.OpenFileAsync(System.IO.Path.GetFullPath(Path));
            m_isOpen = true;
            return ref m_handle;
        }

        public void Close()
        {
            if (m_isOpen)
                m_handle.Close().Complete();
            m_isOpen = false;
        }
    }
}
