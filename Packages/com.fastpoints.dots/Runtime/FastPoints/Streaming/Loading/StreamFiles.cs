using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>The files of finished clouds that a stream keeps open between reads: opening one costs as much as reading a node.
    /// Only a few are open, and none that was not read for a while, so that folders can be replaced. Main thread.</summary>
    internal sealed unsafe class StreamFiles : IDisposable
    {
        /// <summary>The most files of one stream.</summary>
        internal int MostOpen = 64;

        /// <summary>A file that was not read for this many frames is closed.</summary>
        internal const uint FramesToClose = 30;

        static readonly List<StreamFiles> s_all = new List<StreamFiles>();

        readonly List<Kept> m_kept = new List<Kept>(64);

        struct Kept
        {
            public StreamedCloud Cloud;
            public string Path;
            public FileHandle Handle;

            /// <summary>All reads that were begun: the file is closed after them.</summary>
            public JobHandle Reads;
            public uint UsedFrame;
        }

        public StreamFiles() => s_all.Add(this);

        /// <summary>For tests.</summary>
        public List<string> OpenPaths => m_kept.ConvertAll(k => k.Path);

        /// <summary>Begins a read, of a file that stays open if the source allows it.</summary>
        /// <param name="commands">They stay where they are until the read has ended, as does the memory that they name.</param>
        public ReadHandle Read(StreamedCloud cloud, string path, uint frame, ReadCommand* commands, int count)
        {
            // A build renames and deletes its files while they are shown.
            if (!cloud.Source.KeepsFilesOpen)
                return FileReads.Once(path, commands, count);
            int at = IndexOf(cloud, path);
            if (at < 0)
                at = Open(cloud, path);
            var kept = m_kept[at];
            var read = AsyncReadManager.Read(kept.Handle,
                new ReadCommandArray { ReadCommands = commands, CommandCount = count });
            kept.Reads = kept.Reads.IsCompleted ? read.JobHandle
                : JobHandle.CombineDependencies(kept.Reads, read.JobHandle);
            kept.UsedFrame = frame;
            m_kept[at] = kept;
            return read;
        }

        /// <summary>Closes what was not read for a while.</summary>
        public void CloseIdle(uint frame)
        {
            for (int i = m_kept.Count - 1; i >= 0; i--)
                if (frame - m_kept[i].UsedFrame > FramesToClose)
                    Close(i);
        }

        /// <summary>Closes a file whose bytes were wrong or missing: it is opened again, in case another lies there
        /// now.</summary>
        public void Close(StreamedCloud cloud, string path)
        {
            int at = IndexOf(cloud, path);
            if (at >= 0)
                Close(at);
        }

        /// <summary>Closes the files of a cloud.</summary>
        public void Close(StreamedCloud cloud)
        {
            for (int i = m_kept.Count - 1; i >= 0; i--)
                if (m_kept[i].Cloud == cloud)
                    Close(i);
        }

        /// <summary>Closes all files of a folder that is about to be replaced or deleted, in all streams. It waits for reads that
        /// are under way.</summary>
        public static void Leave(string folder)
        {
            string below = Path.GetFullPath(folder).TrimEnd(Path.DirectorySeparatorChar) + Path.DirectorySeparatorChar;
            foreach (var files in s_all)
                for (int i = files.m_kept.Count - 1; i >= 0; i--)
                    if (Path.GetFullPath(files.m_kept[i].Path).StartsWith(below, StringComparison.OrdinalIgnoreCase))
                        files.Close(i).Complete();
        }

        public void Dispose()
        {
            for (int i = m_kept.Count - 1; i >= 0; i--)
                Close(i).Complete();
            s_all.Remove(this);
        }

        int IndexOf(StreamedCloud cloud, string path)
        {
            for (int i = 0; i < m_kept.Count; i++)
                if (m_kept[i].Cloud == cloud && m_kept[i].Path == path)
                    return i;
            return -1;
        }

        int Open(StreamedCloud cloud, string path)
        {
            if (m_kept.Count == MostOpen)
            {
                int oldest = 0;
                for (int i = 1; i < m_kept.Count; i++)
                    if ((int)(m_kept[i].UsedFrame - m_kept[oldest].UsedFrame) < 0)
                        oldest = i;
                Close(oldest);
            }
            m_kept.Add(new Kept { Cloud = cloud, Path = path, Handle = AsyncReadManager.OpenFileAsync(path) });
            return m_kept.Count - 1;
        }

        JobHandle Close(int at)
        {
            var gone = m_kept[at];
            m_kept[at] = m_kept[m_kept.Count - 1];
            m_kept.RemoveAt(m_kept.Count - 1);
            return gone.Handle.Close(gone.Reads);
        }
    }
}
