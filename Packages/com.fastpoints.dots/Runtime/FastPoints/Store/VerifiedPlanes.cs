using System;
using System.Collections.Generic;
using System.IO;

namespace FastPoints.Store
{
    // Which planes of a cloud had the bytes that were written, so that each is hashed once in a run of the application, also if
    // the cloud is opened again, as long as its files are not written to.
    internal sealed class VerifiedPlanes
    {
        // Finished clouds that were opened, by folder.
        static readonly Dictionary<string, VerifiedPlanes> s_opened = new Dictionary<string, VerifiedPlanes>();

        readonly ulong m_rootHash;
        readonly DateTime m_openedUtc = DateTime.UtcNow;
        readonly Dictionary<ulong, VerifiedPage> m_pages = new Dictionary<ulong, VerifiedPage>(); // By hash.

        sealed class VerifiedPage
        {
            public string Path;
            public ulong[] Bits;
        }

        VerifiedPlanes(ulong rootHash) => m_rootHash = rootHash;

        // Any thread: a plane checked later was written before this call or has changed the file's time.
        // Planes of a null folder are not remembered.
        public static VerifiedPlanes Of(ulong rootHash, string folder)
        {
            var now = new VerifiedPlanes(rootHash);
            if (folder == null)
                return now;
            lock (s_opened)
            {
                if (s_opened.TryGetValue(folder, out var before) && before.m_rootHash == now.m_rootHash)
                    now.KeepUnchanged(before);
                s_opened[folder] = now;
            }
            return now;
        }

        // Main thread, as other streams may show the same cloud. Null for a page of which nothing is remembered.
        public ulong[] BitsOf(in PageLink page, string path, long planes)
        {
            lock (m_pages)
            {
                if (!m_pages.TryGetValue(page.Hash, out var known))
                    m_pages.Add(page.Hash, known = new VerifiedPage { Path = path, Bits = new ulong[(planes + 63) / 64] });
                // Two pages with one hash but different sizes (a forged collision): remember nothing.
                return known.Bits.Length == (planes + 63) / 64 ? known.Bits : null;
            }
        }

        public static bool Has(ulong[] bits, long plane) => (bits[plane >> 6] & 1UL << (int)(plane & 63)) != 0;

        public static void Add(ulong[] bits, long plane) => bits[plane >> 6] |= 1UL << (int)(plane & 63);

        void KeepUnchanged(VerifiedPlanes before)
        {
            KeyValuePair<ulong, VerifiedPage>[] pages;
            // The main thread may wait for the lock: not for files.
            lock (before.m_pages)
                pages = new List<KeyValuePair<ulong, VerifiedPage>>(before.m_pages).ToArray();
            var isUnchanged = new Dictionary<string, bool>();
            foreach (var page in pages)
            {
                string path = page.Value.Path;
                if (!isUnchanged.TryGetValue(path, out bool isKept))
                    isUnchanged.Add(path, isKept = File.GetLastWriteTimeUtc(path) < before.m_openedUtc);
                if (isKept)
                    m_pages.Add(page.Key, page.Value);
            }
        }
    }
}
