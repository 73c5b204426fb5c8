using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>Detects changes of a source without reading all of it: it compares bytes and time, and, if the time differs,
    /// hashes of the first and last 64 KiB. A folder counts as the files directly in it; several files count with all names and
    /// sizes, the first one's beginning and the last one's end.</summary>
    /// <remarks>A change in the middle that keeps the size shows in the time alone, and not at all if that was reset.</remarks>
    internal sealed unsafe class SourceStamp
    {
        public const int EdgeBytes = 64 << 10;

        static readonly Comparer<FileInfo> s_byName = Comparer<FileInfo>.Create((a, b) => string.CompareOrdinal(a.Name, b.Name));

        SourceStamp() { }

        public long Bytes { get; private set; }

        public long WrittenTicks { get; private set; } // When the newest of them was written, in ticks of UTC; 0 if unknown.

        public ulong NamesHash { get; private set; }
        public ulong HeadHash { get; private set; }
        public ulong TailHash { get; private set; }

        /// <param name="paths">Files and folders that make one cloud.</param>
        /// <exception cref="PointCloudException">One does not exist or cannot be read.</exception>
        public static SourceStamp Of(IReadOnlyList<string> paths)
        {
            var stamp = new SourceStamp();
            var files = stamp.Measure(paths);
            stamp.HashEdges(files);
            return stamp;
        }

        /// <summary>Finds out how the source has changed. It reads nothing if sizes and times are the same.</summary>
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

        /// <param name="withTime">Whether to write the time too, which differs between machines.</param>
        public void Write(JsonWriter json, string name, bool withTime)
        {
            json.BeginObject(name).Add("bytes", Bytes);
            if (withTime)
                json.Add("writtenTicks", WrittenTicks);
            json.AddHex("names", NamesHash).AddHex("head", HeadHash).AddHex("tail", TailHash).EndObject();
        }

        internal static SourceStamp Read(JsonMembers json) => new SourceStamp
        {
            Bytes = json.Long("bytes"),
            WrittenTicks = json.Has("writtenTicks") ? json.Long("writtenTicks") : 0,
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
                        // This throws if the file does not exist.
                        Bytes += files[i].Length;
                        WrittenTicks = Math.Max(WrittenTicks, files[i].LastWriteTimeUtc.Ticks);
                        names.Append(files[i].Name).Append('|').Append(NumberText.Of(files[i].Length)).Append('\n');
                    }
                }
                catch (Exception e) when (FileFailures.IsFileFailure(e))
                {
                    throw FileFailures.ReadFailure(path, e);
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
            using var source = RandomAccessFile.Open(file.FullName);
            return Hash(source.ReadUpTo(offset, EdgeBytes).Bytes);
        }

        static ulong Hash(byte[] bytes)
        {
            fixed (byte* first = bytes)
                return ContentHash.Of(first, bytes.Length);
        }
    }

    /// <summary>How a cloud's source has changed since it was converted.</summary>
    internal enum SourceChange
    {
        None, // Its bytes are the same, as far as they are compared; its time may differ.
        Changed,
        Missing, // One of its files does not exist or cannot be read.
    }

    /// <summary>Keeps the stamp of a source without a handle, a file in <c>Assets</c>, beside the converted cloud.</summary>
    internal static class StampFile
    {
        const string Extension = ".source.json";
        const int Version = 1;

        public static string PathOf(string cloud) => Path.ChangeExtension(cloud, null) + Extension;

        /// <returns>Null if there is none.</returns>
        /// <exception cref="PointCloudException">It cannot be read, or is not a stamp.</exception>
        public static SourceStamp Read(string cloud)
        {
            string path = PathOf(cloud);
            if (!File.Exists(path))
                return null;
            var json = JsonMembers.Parse(StoreFile.ReadText(path), path);
            json.RequireVersion(Version);
            return SourceStamp.Read(json.ObjectOrNull("stamp") ?? throw json.Failure("stamp", "missing"));
        }

        public static void Write(string cloud, SourceStamp stamp)
        {
            var json = new JsonWriter().BeginObject().Add("version", Version);
            stamp.Write(json, "stamp", true);
            TextFile.Write(PathOf(cloud), json.EndObject().ToString());
        }
    }
}
