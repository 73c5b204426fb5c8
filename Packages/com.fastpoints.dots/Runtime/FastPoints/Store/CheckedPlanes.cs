using System;
using System.Collections.Generic;
using System.IO;

namespace FastPoints.Store
{
    /// <summary>Which planes of a cloud's files had the bytes that were written, so that each is hashed once in a run of the
    /// application. Opening a cloud again keeps this for files whose size and time are the same.</summary>
    internal sealed class CheckedPlanes
    {
        /// <summary>Of the finished clouds that were opened, by folder.</summary>
        static readonly Dictionary<string, CheckedPlanes> s_opened = new Dictionary<string, CheckedPlanes>();

        readonly ulong m_cloudId;
        readonly int m_planeCount;
        readonly CheckedFile[] m_files;

        struct CheckedFile
        {
            public long Bytes;
            public DateTime WrittenUtc;

            /// <summary>A bit for each plane of each node.</summary>
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
                // A file that is not there is noticed when it is read.
                m_files[file] = new CheckedFile
                {
                    Bytes = info.Exists ? info.Length : -1,
                    WrittenUtc = info.Exists ? info.LastWriteTimeUtc : default,
                    Bits = new ulong[((long)files[file].Nodes * m_planeCount + 63) / 64],
                };
            }
        }

        /// <summary>Looks at the files of a folder. Any thread; a plane that is checked later was written before the look or has
        /// changed the file's time.</summary>
        /// <param name="files">The file of the upper levels, then those of the chunks.</param>
        /// <param name="folder">Whose planes are remembered; null for a cloud in the making.</param>
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

        /// <param name="file">0 for the upper levels, 1 and on for the chunks.</param>
        /// <param name="plane">Index in the cloud's layout.</param>
        public bool Has(int file, int node, int plane) => (m_files[file].Bits[WordOf(node, plane)] & BitOf(node, plane)) != 0;

        /// <summary>Main thread, as other streams may show the same cloud.</summary>
        public void Add(int file, int node, int plane) => m_files[file].Bits[WordOf(node, plane)] |= BitOf(node, plane);

        /// <summary>Has a file checked again, since something in it was damaged.</summary>
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
