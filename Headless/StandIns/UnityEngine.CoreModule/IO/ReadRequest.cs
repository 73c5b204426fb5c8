using System;
using System.IO;
using System.Threading;
using StandIns.Scheduling;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace StandIns.Io
{
    /// <summary>One read of several stretches of a file, from the call to the last byte.</summary>
    sealed unsafe class ReadRequest
    {
        internal static readonly HandleTable<ReadRequest> All = new HandleTable<ReadRequest>();

        readonly JobNode m_node = JobScheduler.BeginExternal();
        readonly string m_path;
        readonly OpenFile m_file;
        ReadCommand* m_commands;
        ulong* m_bytesRead;
        int m_count;
        int m_status = (int)ReadStatus.InProgress;
        bool m_cancelled;

        /// <param name="path">A file to open for this read alone, or null where <paramref name="file"/> is given.</param>
        internal ReadRequest(string path, OpenFile file, ReadCommand* commands, int count)
        {
            m_path = path;
            m_file = file;
            // From now on the file stays open for this read, even if it has to wait for a job first.
            file?.AddReader();
            SetCommands(commands, count);
            JobHandle = new JobHandle(m_node);
        }

        internal JobHandle JobHandle { get; }

        internal int Count => m_count;

        internal ReadStatus Status => (ReadStatus)Volatile.Read(ref m_status);

        internal ulong* BytesRead => m_bytesRead;

        internal void Cancel() => Volatile.Write(ref m_cancelled, true);

        /// <summary>The commands of a read that had to wait for a job to write them.</summary>
        internal void SetCommands(ReadCommand* commands, int count)
        {
            m_commands = commands;
            m_count = count;
            if (count == 0)
                return;
            m_bytesRead = (ulong*)Memory.NativeHeap.Allocate((long)count * sizeof(ulong), sizeof(ulong));
            for (int i = 0; i < count; i++)
                m_bytesRead[i] = 0;
        }

        internal void Enqueue() => IoThreads.Enqueue(Read);

        internal void EnqueueInfo(FileInfoResult* result) => IoThreads.Enqueue(() => ReadInfo(result));

        internal void Free()
        {
            if (m_bytesRead != null)
                Memory.NativeHeap.Free(m_bytesRead);
            m_bytesRead = null;
        }

        void Read()
        {
            OpenFile file = m_file;
            if (file == null && !m_cancelled)
            {
                file = OpenFile.OpenHere(m_path);
                file.AddReader();
                file.Close();
            }
            ReadStatus status = ReadStatus.Complete;
            for (int i = 0; i < m_count && status != ReadStatus.Failed; i++)
            {
                if (Volatile.Read(ref m_cancelled))
                    break;
                long read = file.Read((byte*)m_commands[i].Buffer, m_commands[i].Offset, m_commands[i].Size, ref m_cancelled);
                m_bytesRead[i] = (ulong)Math.Max(read, 0);
                if (read < 0)
                    status = ReadStatus.Failed;
                else if (read < m_commands[i].Size)
                    status = ReadStatus.Truncated;
            }
            if (m_count == 0 && file != null && file.Status == FileStatus.OpenFailed)
                status = ReadStatus.Failed;
            file?.RemoveReader();
            Finish(Volatile.Read(ref m_cancelled) ? ReadStatus.Canceled : status);
        }

        void ReadInfo(FileInfoResult* result)
        {
            var status = ReadStatus.Complete;
            try
            {
                var info = new FileInfo(m_path);
                result->FileState = info.Exists ? FileState.Exists : FileState.Absent;
                result->FileSize = info.Exists ? info.Length : 0;
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException
                || exception is ArgumentException)
            {
                status = ReadStatus.Failed;
            }
            Finish(status);
        }

        void Finish(ReadStatus status)
        {
            Volatile.Write(ref m_status, (int)status);
            JobScheduler.FinishExternal(m_node);
        }
    }
}
