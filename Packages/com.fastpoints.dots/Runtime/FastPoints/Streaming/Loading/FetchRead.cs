using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints.Streaming
{
    // What a fetch reads of one file, here or on a web server, in as few pieces as possible. Main thread.
    internal sealed unsafe class FetchRead : IDisposable
    {
        readonly StreamState m_state;
        NativeList<ReadCommand> m_commands = new NativeList<ReadCommand>(64, Allocator.Persistent);
        ReadHandle m_read;
        RemoteRead m_remote;
        bool m_isReading;
        ReadStatus m_status;

        public FetchRead(StreamState state) => m_state = state;

        public string Path { get; private set; }

        // Of the last read of a remote file.
        public PointCloudException Failure { get; private set; }

        public bool HasFailed => m_status != ReadStatus.Complete;

        public ReadStatus Status => m_status;

        public void Clear()
        {
            m_commands.Clear();
            (Path, Failure, m_status) = (null, null, ReadStatus.Complete);
        }

        // Of pieces in the order of their offsets. Those that are no farther apart than the gap are read as one. Returns the
        // bytes that are read more than before; the piece is at their end.
        public long Add(long offset, long bytes, long gap)
        {
            int last = m_commands.Length - 1;
            long lastEnd = last < 0 ? 0 : m_commands[last].Offset + m_commands[last].Size;
            if (last < 0 || offset < lastEnd || offset - lastEnd > gap)
            {
                m_commands.Add(new ReadCommand { Offset = offset, Size = bytes });
                return bytes;
            }
            m_commands.ElementAt(last).Size += offset + bytes - lastEnd;
            return offset + bytes - lastEnd;
        }

        // Returns the end of what is read.
        public byte* Begin(StreamedCloud cloud, string path, RemoteFile remote, int rank, byte* to)
        {
            if (m_commands.Length == 0)
                return to;
            Path = path;
            for (int i = 0; i < m_commands.Length; i++)
            {
                m_commands.ElementAt(i).Buffer = to;
                to += m_commands[i].Size;
            }
            if (remote != null)
                m_remote = remote.Begin(m_commands.GetUnsafePtr(), m_commands.Length, rank);
            else
                m_read = m_state.Files.Read(cloud, path, m_state.Selector.Frame, m_commands.GetUnsafePtr(), m_commands.Length);
            m_isReading = true;
            return to;
        }

        public void SetRank(int rank)
        {
            if (m_remote != null)
                m_remote.Rank = rank;
        }

        // The read continues until it reports its end.
        public void Cancel()
        {
            if (m_remote != null)
                m_remote.Cancel();
            else if (m_isReading)
                m_read.Cancel();
        }

        public bool HasEnded()
        {
            if (!m_isReading)
                return true;
            // Its status is not enough: a read that waits for its file has one that the enum lacks.
            if (m_remote != null ? !m_remote.IsDone : !JobCoroutine.HasEnded(m_read.JobHandle))
                return false;
            if (m_remote != null)
            {
                Failure = m_remote.Failure;
                m_status = m_remote.IsCancelled ? ReadStatus.Canceled : Failure != null ? ReadStatus.Failed : ReadStatus.Complete;
                m_remote = null;
            }
            else
            {
                m_read.JobHandle.Complete();
                m_status = m_read.Status;
                m_read.Dispose();
                m_read = default;
            }
            m_isReading = false;
            return true;
        }

        // Waits for a file of this machine.
        public void Abandon()
        {
            if (m_remote != null)
            {
                m_remote.Cancel();
                m_remote = null;
            }
            else if (m_isReading)
            {
                m_read.JobHandle.Complete();
                m_read.Dispose();
            }
            m_isReading = false;
        }

        public void Dispose() => m_commands.Dispose();
    }
}
