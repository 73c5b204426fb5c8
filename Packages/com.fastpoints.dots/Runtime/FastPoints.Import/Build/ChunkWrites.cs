using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Files of finished chunks that wait to be written, so that the next chunks need not wait for the disk. There are
    /// as many as memory allows: the writing code gets an empty list in exchange.</summary>
    sealed class ChunkWrites : IDisposable
    {
        struct Pending
        {
            public int Chunk;
            public WriteTicket Written;
            public NativeList<byte> File;
            public NativeArray<byte> Top;
        }

        readonly CloudFolderWriter m_folder;
        readonly ChunkSet m_chunks;
        readonly RecordFiles m_files;
        readonly int m_max;
        readonly Queue<Pending> m_pending = new Queue<Pending>();
        readonly Stack<NativeList<byte>> m_spare = new Stack<NativeList<byte>>();

        /// <param name="files">Released when a chunk that came from them is on disk; null if all points are in memory.</param>
        /// <param name="max">The most files that may wait.</param>
        public ChunkWrites(CloudFolderWriter folder, ChunkSet chunks, RecordFiles files, int max)
        {
            m_folder = folder;
            m_chunks = chunks;
            m_files = files;
            m_max = max;
        }

        /// <summary>Whether one more file may wait.</summary>
        public bool HasRoom => m_pending.Count < m_max;

        /// <summary>Whether everything is on disk.</summary>
        public bool IsDone => m_pending.Count == 0;

        /// <summary>Queues a chunk's file and, if points are in files, what a resumed build has to know.</summary>
        /// <param name="file">The chunk's file; nothing is written if it is empty.</param>
        /// <param name="top">The chunk's top, or not created; this object takes it over.</param>
        /// <returns>An empty list in exchange for the file.</returns>
        public NativeList<byte> Write(int chunk, NativeList<byte> file, NativeArray<byte> top)
        {
            var pending = new Pending { Chunk = chunk, File = file, Top = top };
            if (file.Length > 0)
                pending.Written = m_folder.Write(StoreFormat.ChunkPath(chunk), file.AsArray());
            // This comes after the chunk's own file: once it exists, the chunk is done.
            if (top.IsCreated)
                pending.Written = m_folder.Write(BuildFiles.TopPath(chunk), top);
            if (pending.Written == null)
                return file;
            m_pending.Enqueue(pending);
            return m_spare.Count > 0 ? m_spare.Pop() : new NativeList<byte>(1024, Allocator.Persistent);
        }

        /// <summary>Takes back what has been written since; waits at most this long for the first file.</summary>
        public void Poll(int waitMs)
        {
            // They are written one after another.
            while (m_pending.Count > 0 && m_pending.Peek().Written.IsDone(waitMs))
            {
                var done = m_pending.Dequeue();
                waitMs = 0;
                done.File.Clear();
                m_spare.Push(done.File);
                if (!done.Top.IsCreated)
                    continue;
                done.Top.Dispose();
                foreach (var run in m_chunks.Chunks[done.Chunk].Runs)
                    m_files.Release(run.File);
            }
        }

        /// <summary>Whether a chunk's file is not on disk yet.</summary>
        public bool HasPending(int chunk)
        {
            foreach (var pending in m_pending)
                if (pending.Chunk == chunk)
                    return true;
            return false;
        }

        public void Dispose()
        {
            while (m_pending.Count > 0)
            {
                var pending = m_pending.Dequeue();
                pending.Written.Wait();
                pending.File.Dispose();
                if (pending.Top.IsCreated)
                    pending.Top.Dispose();
            }
            while (m_spare.Count > 0)
                m_spare.Pop().Dispose();
        }
    }
}
