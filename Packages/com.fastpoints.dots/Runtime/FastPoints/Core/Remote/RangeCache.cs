using System;
using System.Collections.Generic;
using System.IO;

namespace FastPoints
{
    // Ranges of remote files on this disk, by their file's address and version. They are appended to segments, each of one
    // process alone, and checked before use: a process may be killed at any moment, and several may share the folder. The
    // segments that were used longest ago are deleted when there are too many bytes. Any thread; it waits for the disk.
    internal sealed class RangeCache
    {
        const string Extension = ".ranges";
        const long MaxSegmentBytes = 32 << 20;
        const int MinSegments = 8;
        const int MaxOverlaps = 8;
        const int MaxRemoteSegments = 160; // Each is an open file.

        static readonly object s_lock = new object();
        static RangeCache s_current;

        readonly object m_lock = new object();
        readonly long m_maxBytes;
        readonly int m_maxSegments;
        readonly Dictionary<FileVersionKey, List<Entry>> m_entries = new Dictionary<FileVersionKey, List<Entry>>();
        readonly List<RangeCacheFile> m_segments = new List<RangeCacheFile>();
        RangeCacheFile m_written;
        bool m_isReadOnly;

        struct Entry
        {
            public RangeCacheFile Segment;
            public long Position;
            public long Offset;
            public int Length;
        }

        public RangeCache(string folder, long maxBytes, int maxSegments)
        {
            (Folder, m_maxBytes, m_maxSegments) = (folder, maxBytes, maxSegments);
            Scan();
        }

        // Null if there is to be none.
        public static RangeCache Current
        {
            get
            {
                if (RemoteAccess.CacheBytes <= 0)
                    return null;
                string folder = RemoteAccess.CacheFolder ?? FolderOfUser("remote");
                lock (s_lock)
                {
                    if (s_current?.Folder != folder || s_current.m_maxBytes != RemoteAccess.CacheBytes)
                    {
                        s_current?.Close();
                        s_current = new RangeCache(folder, RemoteAccess.CacheBytes, MaxRemoteSegments);
                    }
                    return s_current;
                }
            }
        }

        public static string FolderOfUser(string name)
        {
            string data = Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData,
                Environment.SpecialFolderOption.Create);
            return Path.Combine(data.Length > 0 ? data : Path.GetTempPath(), "FastPoints", name);
        }

        public string Folder { get; }

        public long Bytes
        {
            get
            {
                lock (m_lock)
                    return Sum();
            }
        }

        public int Count
        {
            get
            {
                lock (m_lock)
                {
                    int count = 0;
                    foreach (var entries in m_entries.Values)
                        count += entries.Count;
                    return count;
                }
            }
        }

        // Whether it has all of them, undamaged; into may be written either way.
        public bool TryRead(FileVersionKey key, long offset, Span<byte> into)
        {
            lock (m_lock)
            {
                if (!m_entries.TryGetValue(key, out var entries))
                    return false;
                while (into.Length > 0)
                {
                    int at = LastAt(entries, offset);
                    // A shorter one may lie in a longer one.
                    for (int last = at; at >= 0 && entries[at].Offset + entries[at].Length <= offset; at--)
                        if (last - at == MaxOverlaps)
                            return false;
                    if (at < 0)
                        return false;
                    var entry = entries[at];
                    int from = (int)(offset - entry.Offset), count = Math.Min(into.Length, entry.Length - from);
                    if (!entry.Segment.TryRead(entry.Position, from, into.Slice(0, count)))
                    {
                        entries.RemoveAt(at);
                        return false;
                    }
                    into = into.Slice(count);
                    offset += count;
                }
                return true;
            }
        }

        public byte[] ReadLastRange(FileVersionKey key)
        {
            lock (m_lock)
            {
                var bytes = new byte[LastRangeLength(key)];
                return bytes.Length > 0 && TryRead(key, m_entries[key][m_entries[key].Count - 1].Offset, bytes) ? bytes : null;
            }
        }

        public int LastRangeLength(FileVersionKey key)
        {
            lock (m_lock)
                return m_entries.TryGetValue(key, out var entries) && entries.Count > 0 ? entries[entries.Count - 1].Length : 0;
        }

        public void Add(FileVersionKey key, long offset, ReadOnlySpan<byte> bytes)
        {
            lock (m_lock)
            {
                if (m_isReadOnly || bytes.Length == 0 || bytes.Length > m_maxBytes / MinSegments)
                    return;
                try
                {
                    if (m_written != null && !HasRoom(bytes.Length))
                        m_written = null;
                    if (m_written == null)
                    {
                        Directory.CreateDirectory(Folder);
                        Scan();
                        m_written = RangeCacheFile.Create(Folder, Extension);
                        m_segments.Add(m_written);
                        Compact();
                    }
                    Append(key, offset, bytes);
                    Shrink();
                }
                catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
                {
                    // The disk is full, or not ours: what was written is read all the same.
                    m_isReadOnly = true;
                }
            }
        }

        bool HasRoom(long bytes) => m_written.Bytes + bytes <= Math.Min(MaxSegmentBytes, m_maxBytes / MinSegments);

        void Append(FileVersionKey key, long offset, ReadOnlySpan<byte> bytes)
        {
            long position = m_written.Append(key, offset, bytes);
            Insert(key, new Entry { Segment = m_written, Position = position, Offset = offset, Length = bytes.Length });
        }

        // Short runs leave short segments: of too many, those used longest ago go into the one that is written.
        void Compact()
        {
            if (m_segments.Count <= m_maxSegments)
                return;
            var byUse = m_segments.FindAll(s => s != m_written);
            byUse.Sort((a, b) => a.LastUsedUtc.CompareTo(b.LastUsedUtc));
            foreach (var segment in byUse)
            {
                if (m_segments.Count <= m_maxSegments / 2)
                    return;
                if (!HasRoom(segment.Bytes))
                    continue;
                segment.Scan((key, position, offset, length) =>
                {
                    var bytes = new byte[length];
                    if (segment.TryRead(position, 0, bytes))
                        Append(key, offset, bytes);
                });
                Delete(m_segments.IndexOf(segment));
            }
        }

        public void ForgetEntries(FileVersionKey key)
        {
            lock (m_lock)
                m_entries.Remove(key);
        }

        // Deletes what no process has open; on Windows others' segments may stay.
        public void Clear()
        {
            lock (m_lock)
            {
                Scan();
                for (int i = m_segments.Count - 1; i >= 0; i--)
                    Delete(i);
            }
        }

        // It is read and written no more.
        public void Close()
        {
            m_isReadOnly = true;
            lock (m_lock)
                foreach (var segment in m_segments)
                    segment.Close();
        }

        // Finds the segments that others have written, and forgets those that they have deleted.
        void Scan()
        {
            var known = new HashSet<string>();
            foreach (var segment in m_segments)
                known.Add(segment.Path);
            string[] paths;
            try
            {
                paths = Directory.GetFiles(Folder, "*" + Extension);
                Array.Sort(paths, StringComparer.Ordinal); // By their time: what was written last counts.
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                return;
            }
            for (int i = m_segments.Count - 1; i >= 0; i--)
                if (Array.IndexOf(paths, m_segments[i].Path) < 0)
                    Forget(i);
            foreach (string path in paths)
            {
                if (known.Contains(path) || !RangeCacheFile.TryOpen(path, out var segment))
                    continue;
                m_segments.Add(segment);
                segment.Scan((key, position, offset, length) =>
                    Insert(key, new Entry { Segment = segment, Position = position, Offset = offset, Length = length }));
            }
        }

        void Insert(FileVersionKey key, in Entry entry)
        {
            if (!m_entries.TryGetValue(key, out var entries))
                m_entries.Add(key, entries = new List<Entry>());
            entries.Insert(LastAt(entries, entry.Offset) + 1, entry);
        }

        // The last one that begins at or before an offset; -1 for none.
        static int LastAt(List<Entry> entries, long offset)
        {
            int low = 0, high = entries.Count;
            while (low < high)
            {
                int middle = (low + high) / 2;
                if (entries[middle].Offset <= offset)
                    low = middle + 1;
                else
                    high = middle;
            }
            return low - 1;
        }

        void Shrink()
        {
            while (Sum() > m_maxBytes && m_segments.Count > 1)
            {
                int oldest = -1;
                for (int i = 0; i < m_segments.Count; i++)
                    if (m_segments[i] != m_written && (oldest < 0 || m_segments[i].LastUsedUtc < m_segments[oldest].LastUsedUtc))
                        oldest = i;
                Delete(oldest);
            }
        }

        void Delete(int index)
        {
            var segment = m_segments[index];
            Forget(index);
            try
            {
                FileChanges.Delete(segment.Path);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                // Another process has it open: the next one that looks deletes it.
            }
        }

        void Forget(int index)
        {
            var segment = m_segments[index];
            segment.Close();
            m_segments.RemoveAt(index);
            if (segment == m_written)
                m_written = null;
            var empty = new List<FileVersionKey>();
            foreach (var pair in m_entries)
                if (pair.Value.RemoveAll(e => e.Segment == segment) > 0 && pair.Value.Count == 0)
                    empty.Add(pair.Key);
            foreach (var key in empty)
                m_entries.Remove(key);
        }

        long Sum()
        {
            long sum = 0;
            foreach (var segment in m_segments)
                sum += segment.Bytes;
            return sum;
        }
    }
}
