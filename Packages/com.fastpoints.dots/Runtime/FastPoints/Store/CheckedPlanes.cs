using System;
using System.Collections.Generic;
using System.IO;

namespace FastPoints.Store
{
    // Which planes of a cloud's files had the bytes that were written, so that each is hashed once in a run of the application,
    // also if the cloud is opened again, as long as the files' sizes and times are the same.
    internal sealed class CheckedPlanes
    {
        // Finished clouds that were opened, by folder.
        static readonly Dictionary<string, CheckedPlanes> s_opened = new Dictionary<string, CheckedPlanes>();

        readonly ulong m_cloudId;
        readonly int m_planeCount;
        readonly CheckedFile[] m_files;

        struct CheckedFile
        {
            public long Bytes;
            public DateTime WrittenUtc;
            public ulong[] Bits;
        }

        CheckedPlanes(ulong cloudId, int planeCount, IReadOnlyList<(string Path, int Nodes)> files)
        {
            m_cloudId = cloudId;
            m_planeCount = planeCount;
            m_files = new CheckedFile[files.Count];
            for (int file = 0; file < m_files.Length; file++)
            {
                var info = new FileInfo(files[file].Path);
                // A missing file is noticed when it is read.
                m_files[file] = new CheckedFile
                {
                    Bytes = info.Exists ? info.Length : -1,
                    WrittenUtc = info.Exists ? info.LastWriteTimeUtc : default,
                    Bits = new ulong[((long)files[file].Nodes * m_planeCount + 63) / 64],
                };
            }
        }

        // The first file is that of the upper levels; planes of a null folder are not remembered. Any thread: a plane
        // checked later was written before this call or has changed the file's time.
        public static CheckedPlanes Of(ulong cloudId, int planeCount, IReadOnlyList<(string Path, int Nodes)> files,
            string folder)
        {
            var now = new CheckedPlanes(cloudId, planeCount, files);
            if (folder == null)
                return now;
            lock (s_opened)
            {
                if (s_opened.TryGetValue(folder, out var before) && before.m_cloudId == now.m_cloudId &&
                    before.m_planeCount == now.m_planeCount && before.m_files.Length == now.m_files.Length)
                    now.KeepUnchanged(before.m_files);
                s_opened[folder] = now;
            }
            return now;
        }

        public bool Has(int file, int node, int plane) => (m_files[file].Bits[WordOf(node, plane)] & BitOf(node, plane)) != 0;

        // Main thread, as other streams may show the same cloud.
        public void Add(int file, int node, int plane) => m_files[file].Bits[WordOf(node, plane)] |= BitOf(node, plane);

        // Has a file checked again, since something in it was damaged.
        public void Forget(int file) => Array.Clear(m_files[file].Bits, 0, m_files[file].Bits.Length);

        long WordOf(int node, int plane) => ((long)node * m_planeCount + plane) >> 6;

        ulong BitOf(int node, int plane) => 1UL << (int)(((long)node * m_planeCount + plane) & 63);

        void KeepUnchanged(CheckedFile[] before)
        {
            for (int file = 0; file < m_files.Length; file++)
            {
                ref var now = ref m_files[file];
                if (before[file].Bytes == now.Bytes && before[file].WrittenUtc == now.WrittenUtc &&
                    before[file].Bits.Length == now.Bits.Length)
                    now.Bits = before[file].Bits;
            }
        }
    }
}
