using System;
using System.Collections.Generic;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    // The files of finished clouds that a stream keeps open between reads: opening one costs as much as reading a node.
    // Only a few are open, and none that was not read for a while, so that folders can be replaced. Main thread.
    internal sealed unsafe class StreamFiles : IOpenFiles, IDisposable
    {
        internal int MaxOpenFiles = 64;
        internal uint FramesToClose = 30;

        readonly List<OpenedFile> m_kept = new List<OpenedFile>(64);
        JobHandle m_uncachedReads; // Reads of files that are not kept open.

        struct OpenedFile
        {
            public StreamedCloud Cloud;
            public string Path;
            public FileHandle Handle;
            public JobHandle Reads; // The file is closed after them.
            public uint UsedFrame;
        }

        public StreamFiles() => FolderReleases.Add(this);
        public List<string> OpenPaths => m_kept.ConvertAll(k => k.Path); // For tests.

        // The file stays open if the source allows it. Commands and their memory stay where they are until the read has ended.
        public ReadHandle Read(StreamedCloud cloud, string path, uint frame, ReadCommand* commands, int count)
        {
            // A build renames and deletes its files while they are shown.
            if (!cloud.Source.KeepsFilesOpen)
            {
                var loose = FileReads.BeginOneShot(path, commands, count, out var closed);
                m_uncachedReads = FolderReleases.Combine(m_uncachedReads, closed);
                return loose;
            }
            int at = IndexOf(cloud, path);
            if (at < 0)
                at = Open(cloud, path);
            var kept = m_kept[at];
            var read = AsyncReadManager.Read(kept.Handle,
                new ReadCommandArray { ReadCommands = commands, CommandCount = count });
            kept.Reads = FolderReleases.Combine(kept.Reads, read.JobHandle);
            kept.UsedFrame = frame;
            m_kept[at] = kept;
            return read;
        }

        public void CloseIdle(uint frame)
        {
            for (int i = m_kept.Count - 1; i >= 0; i--)
                if (frame - m_kept[i].UsedFrame > FramesToClose)
                    Close(i);
        }

        // Its bytes were wrong or missing: it is opened again, in case another lies there now.
        public void Close(StreamedCloud cloud, string path)
        {
            int at = IndexOf(cloud, path);
            if (at >= 0)
                Close(at);
        }

        public void Close(StreamedCloud cloud)
        {
            for (int i = m_kept.Count - 1; i >= 0; i--)
                if (m_kept[i].Cloud == cloud)
                    Close(i);
        }

        JobHandle IOpenFiles.OtherReads => m_uncachedReads;

        JobHandle IOpenFiles.CloseBelow(string folder)
        {
            var closing = default(JobHandle);
            for (int i = m_kept.Count - 1; i >= 0; i--)
                if (FolderReleases.IsBelow(m_kept[i].Path, folder))
                    closing = FolderReleases.Combine(closing, Close(i));
            return closing;
        }

        public void Dispose()
        {
            for (int i = m_kept.Count - 1; i >= 0; i--)
                Close(i).Complete();
            FolderReleases.Remove(this);
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
            if (m_kept.Count == MaxOpenFiles)
            {
                int oldest = 0;
                for (int i = 1; i < m_kept.Count; i++)
                    if ((int)(m_kept[i].UsedFrame - m_kept[oldest].UsedFrame) < 0)
                        oldest = i;
                Close(oldest);
            }
            m_kept.Add(new OpenedFile { Cloud = cloud, Path = path, Handle = AsyncReadManager.OpenFileAsync(path) });
            return m_kept.Count - 1;
        }

        JobHandle Close(int at)
        {
            var closed = m_kept[at];
            m_kept[at] = m_kept[m_kept.Count - 1];
            m_kept.RemoveAt(m_kept.Count - 1);
            return closed.Handle.Close(closed.Reads);
        }
    }
}
