using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Core;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    // The files of finished clouds that a stream keeps open between reads: opening one costs as much as reading a node. Only a
    // few are open, and none that was not read for a while, so that folders can be replaced. Main thread.
    internal sealed unsafe class StreamFiles : IDisposable
    {
        internal int MaxOpenFiles = 64;
        internal const uint FramesToClose = 30;

        static readonly List<StreamFiles> s_all = new List<StreamFiles>();

        // Folders that are not to be read now: another array with each change, which any thread may make.
        static string[] s_left = Array.Empty<string>();

        static JobHandle s_closing;

        readonly List<OpenedFile> m_kept = new List<OpenedFile>(64);
        JobHandle m_loose; // Reads of files that are not kept open.

        struct OpenedFile
        {
            public StreamedCloud Cloud;
            public string Path;
            public FileHandle Handle;
            public JobHandle Reads; // The file is closed after them.
            public uint UsedFrame;
        }

        public StreamFiles() => s_all.Add(this);

        // For tests.
        public List<string> OpenPaths => m_kept.ConvertAll(k => k.Path);

        // The file stays open if the source allows it. Commands and their memory stay where they are until the read has ended.
        public ReadHandle Read(StreamedCloud cloud, string path, uint frame, ReadCommand* commands, int count)
        {
            // A build renames and deletes its files while they are shown.
            if (!cloud.Source.KeepsFilesOpen)
            {
                var loose = FileReads.BeginOneShot(path, commands, count, out var closed);
                m_loose = Combine(m_loose, closed);
                return loose;
            }
            int at = IndexOf(cloud, path);
            if (at < 0)
                at = Open(cloud, path);
            var kept = m_kept[at];
            var read = AsyncReadManager.Read(kept.Handle,
                new ReadCommandArray { ReadCommands = commands, CommandCount = count });
            kept.Reads = Combine(kept.Reads, read.JobHandle);
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

        // Lets go of a folder that is about to be renamed or deleted, in all streams: none of its files is read until
        // Reacquire.
        public static void Release(string folder)
        {
            string below = Below(folder);
            lock (s_all)
                s_left = new List<string>(s_left) { below }.ToArray();
            foreach (var files in s_all)
                for (int i = files.m_kept.Count - 1; i >= 0; i--)
                    if (IsBelow(files.m_kept[i].Path, below))
                        s_closing = Combine(s_closing, files.Close(i));
        }

        // Whether reads that were in flight in released folders have ended, and their files are closed.
        public static bool HasReleased
        {
            get
            {
                bool hasLeft = JobCoroutine.HasEnded(s_closing);
                foreach (var files in s_all)
                    hasLeft &= JobCoroutine.HasEnded(files.m_loose);
                return hasLeft;
            }
        }

        // On any thread.
        public static void Reacquire(string folder)
        {
            lock (s_all)
            {
                var left = new List<string>(s_left);
                left.Remove(Below(folder));
                s_left = left.ToArray();
            }
        }

        public static bool IsReleased(NodeSource source)
        {
            // This is asked often, and only while a folder is renamed does it cost anything.
            foreach (string left in s_left)
                if (IsBelow(Below(source.Path), left))
                    return true;
            return false;
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
            var gone = m_kept[at];
            m_kept[at] = m_kept[m_kept.Count - 1];
            m_kept.RemoveAt(m_kept.Count - 1);
            return gone.Handle.Close(gone.Reads);
        }

        static JobHandle Combine(JobHandle a, JobHandle b) => a.IsCompleted ? b : JobHandle.CombineDependencies(a, b);

        static string Below(string folder) =>
            Path.GetFullPath(folder).TrimEnd(Path.DirectorySeparatorChar) + Path.DirectorySeparatorChar;

        static bool IsBelow(string path, string below) =>
            Path.GetFullPath(path).StartsWith(below, StringComparison.OrdinalIgnoreCase);
    }
}
