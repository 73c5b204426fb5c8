using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>
    /// Tells a source from a changed one without reading it whole: bytes, time, and where the time is another, hashes of its
    /// first and last 64 KiB. Of a folder, the files that lie in it directly; of several, all names and sizes, the first one's
    /// beginning and the last one's end.
    /// </summary>
    /// <remarks>A change in the middle that keeps the size is seen by its time alone, and where that was put back, not at
    /// all.</remarks>
    internal sealed unsafe class SourceStamp
    {
        /// <summary>Bytes at each end that are hashed.</summary>
        public const int EdgeBytes = 64 << 10;

        static readonly Comparer<FileInfo> s_byName = Comparer<FileInfo>.Create((a, b) => string.CompareOrdinal(a.Name, b.Name));

        SourceStamp()
        {
        }

        /// <summary>Of all files.</summary>
        public long Bytes { get; private set; }

        /// <summary>When the newest of them was written: ticks of UTC.</summary>
        public long WrittenTicks { get; private set; }

        public ulong NamesHash { get; private set; }
        public ulong HeadHash { get; private set; }
        public ulong TailHash { get; private set; }

        /// <param name="paths">Files and folders that make one cloud.</param>
        /// <exception cref="PointCloudException">One is not there, or cannot be read.</exception>
        public static SourceStamp Of(IReadOnlyList<string> paths)
        {
            var stamp = new SourceStamp();
            var files = stamp.Measure(paths);
            stamp.HashEdges(files);
            return stamp;
        }

        /// <summary>What became of the source. Reads nothing where sizes and times are the same.</summary>
        public SourceChange Compare(IReadOnlyList<string> paths)
        {
            try
            {
                var now = new SourceStamp();
                var files = now.Measure(paths);
                if (now.Bytes != Bytes || now.NamesHash != NamesHash)
                    return SourceChange.Changed;
                if (now.WrittenTicks == WrittenTicks)
                    return SourceChange.None;
                now.HashEdges(files);
                return HasBytesOf(now) ? SourceChange.None : SourceChange.Changed;
            }
            catch (PointCloudException)
            {
                return SourceChange.Missing;
            }
        }

        /// <summary>Whether two stamps differ in time alone.</summary>
        public bool HasBytesOf(SourceStamp other) => Bytes == other.Bytes && NamesHash == other.NamesHash &&
            HeadHash == other.HeadHash && TailHash == other.TailHash;

        public void Write(JsonWriter json, string name) => json.BeginObject(name).Add("bytes", Bytes)
            .Add("writtenTicks", WrittenTicks).AddHex("names", NamesHash).AddHex("head", HeadHash).AddHex("tail", TailHash)
            .EndObject();

        internal static SourceStamp Read(JsonMembers json) => new SourceStamp
        {
            Bytes = json.Long("bytes"),
            WrittenTicks = json.Long("writtenTicks"),
            NamesHash = json.Hex("names"),
            HeadHash = json.Hex("head"),
            TailHash = json.Hex("tail"),
        };

        List<FileInfo> Measure(IReadOnlyList<string> paths)
        {
            var files = new List<FileInfo>();
            var names = new StringBuilder();
            foreach (string path in paths)
            {
                try
                {
                    int first = files.Count;
                    if (Directory.Exists(path))
                        files.AddRange(new DirectoryInfo(path).GetFiles());
                    else
                        files.Add(new FileInfo(path));
                    files.Sort(first, files.Count - first, s_byName);
                    for (int i = first; i < files.Count; i++)
                    {
                        // Throws where the file is not there.
                        Bytes += files[i].Length;
                        WrittenTicks = Math.Max(WrittenTicks, files[i].LastWriteTimeUtc.Ticks);
                        names.Append(files[i].Name).Append('|')
                            .Append(NumberText.Of(files[i].Length)).Append('\n');
                    }
                }
                catch (Exception e) when (FileFailures.IsFileFailure(e))
                {
                    throw FileFailures.Reading(path, e);
                }
            }
            NamesHash = Hash(Encoding.UTF8.GetBytes(names.ToString()));
            return files;
        }

        void HashEdges(List<FileInfo> files)
        {
            if (files.Count == 0)
                return;
            HeadHash = HashOf(files[0], 0);
            var last = files[files.Count - 1];
            TailHash = HashOf(last, Math.Max(0, last.Length - EdgeBytes));
        }

        static ulong HashOf(FileInfo file, long offset)
        {
            if (file.Length == 0)
                return Hash(Array.Empty<byte>());
            using (var source = FileSource.Open(file.FullName))
                return Hash(source.ReadAtMost(offset, EdgeBytes).Bytes);
        }

        static ulong Hash(byte[] bytes)
        {
            fixed (byte* first = bytes)
                return ContentHash.Of(first, bytes.Length);
        }
    }

    /// <summary>What became of a cloud's source since it was converted.</summary>
    internal enum SourceChange
    {
        /// <summary>Its bytes are the same, as far as is looked; its time may be another.</summary>
        None,
        Changed,
        /// <summary>A file of it is not there, or cannot be read.</summary>
        Missing,
    }
}
