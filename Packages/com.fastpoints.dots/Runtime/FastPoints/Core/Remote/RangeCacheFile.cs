using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;

namespace FastPoints
{
    // A file of a range cache: records, one behind the other, of which only whole ones count. A record has a header, a hash for
    // each block of its bytes, and the bytes.
    internal sealed class RangeCacheFile
    {
        const int BlockBytes = 16 << 10;
        const ulong Magic = 0x3145474E41525046; // FPRANGE1
        static readonly TimeSpan s_useEvery = TimeSpan.FromMinutes(1);
        static int s_number;

        readonly FileStream m_stream;

        [StructLayout(LayoutKind.Sequential)]
        struct Header
        {
            public ulong Magic;
            public ulong KeyA;
            public ulong KeyB;
            public long Offset;
            public long Length;
            public ulong BlocksHash;
            public ulong HeaderHash; // Of all before it.
        }

        const int HeaderBytes = 56;

        RangeCacheFile(string path, FileStream stream)
        {
            Path = path;
            m_stream = stream;
            Bytes = stream.Length;
            Used = File.GetLastWriteTimeUtc(path);
        }

        public string Path { get; }
        public long Bytes { get; private set; }
        public DateTime Used { get; private set; }

        public static RangeCacheFile Create(string folder, string extension)
        {
            string name = DateTime.UtcNow.Ticks.ToString("x16", CultureInfo.InvariantCulture) + "-" +
                Process.GetCurrentProcess().Id.ToString(CultureInfo.InvariantCulture) + "-" +
                Interlocked.Increment(ref s_number).ToString(CultureInfo.InvariantCulture);
            string path = System.IO.Path.Combine(folder, name + extension);
            return new RangeCacheFile(path, FileChanges.CreateShared(path));
        }

        public static bool TryOpen(string path, out RangeCacheFile segment)
        {
            segment = null;
            try
            {
                segment = new RangeCacheFile(path, FileChanges.OpenToRead(path, 4096));
                return true;
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                return false;
            }
        }

        public void Scan(Action<FileVersionKey, long, long, int> found)
        {
            try
            {
                for (long position = 0; TryReadHeader(position, out var header); position += RecordBytes((int)header.Length))
                    found(new FileVersionKey(header.KeyA, header.KeyB), position, header.Offset, (int)header.Length);
            }
            catch (IOException)
            {
                // What was found until then counts.
            }
        }

        // Returns the record's position.
        public long Append(FileVersionKey key, long offset, ReadOnlySpan<byte> bytes)
        {
            var hashes = new ulong[BlocksOf(bytes.Length)];
            for (int i = 0; i < hashes.Length; i++)
                hashes[i] = ContentHash.Of(bytes.Slice(i * BlockBytes, Math.Min(BlockBytes, bytes.Length - i * BlockBytes)));
            var header = new Header
            {
                Magic = Magic,
                KeyA = key.A,
                KeyB = key.B,
                Offset = offset,
                Length = bytes.Length,
                BlocksHash = ContentHash.Of(MemoryMarshal.AsBytes(hashes.AsSpan())),
            };
            header.HeaderHash = HashOf(ref header);
            long position = Bytes;
            m_stream.Position = position;
            m_stream.Write(AsBytes(ref header));
            m_stream.Write(MemoryMarshal.AsBytes(hashes.AsSpan()));
            m_stream.Write(bytes);
            m_stream.Flush();
            Bytes = position + RecordBytes(bytes.Length);
            return position;
        }

        // Bytes of a record from an index on; false if they are damaged.
        public bool TryRead(long position, int from, Span<byte> into)
        {
            try
            {
                if (!TryReadHeader(position, out var header) || from + into.Length > header.Length)
                    return false;
                var hashes = new ulong[BlocksOf((int)header.Length)];
                if (!TryFill(MemoryMarshal.AsBytes(hashes.AsSpan())) ||
                    ContentHash.Of(MemoryMarshal.AsBytes(hashes.AsSpan())) != header.BlocksHash)
                    return false;
                int block = from / BlockBytes;
                m_stream.Position = position + HeaderBytes + 8L * hashes.Length + (long)block * BlockBytes;
                Span<byte> bytes = new byte[Math.Min(BlockBytes, (int)header.Length)];
                for (int begin = from - block * BlockBytes; into.Length > 0; block++, begin = 0)
                {
                    var whole = bytes.Slice(0, Math.Min(BlockBytes, (int)header.Length - block * BlockBytes));
                    if (!TryFill(whole) || ContentHash.Of(whole) != hashes[block])
                        return false;
                    int count = Math.Min(into.Length, whole.Length - begin);
                    whole.Slice(begin, count).CopyTo(into);
                    into = into.Slice(count);
                }
                Use();
                return true;
            }
            catch (Exception e) when (e is IOException || e is ObjectDisposedException)
            {
                return false;
            }
        }

        public void Close() => m_stream.Dispose();

        // The time of the file's last change is when it was used last, for all processes.
        void Use()
        {
            var now = DateTime.UtcNow;
            if (now - Used < s_useEvery)
                return;
            Used = now;
            try
            {
                File.SetLastWriteTimeUtc(Path, now);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                // It has gone, or is another user's.
            }
        }

        bool TryReadHeader(long position, out Header header)
        {
            header = default;
            m_stream.Position = position;
            return TryFill(AsBytes(ref header)) && header.Magic == Magic && header.HeaderHash == HashOf(ref header) &&
                header.Length > 0 && header.Length <= int.MaxValue &&
                position + RecordBytes((int)header.Length) <= m_stream.Length;
        }

        bool TryFill(Span<byte> into)
        {
            while (into.Length > 0)
            {
                int read = m_stream.Read(into);
                if (read == 0)
                    return false;
                into = into.Slice(read);
            }
            return true;
        }

        static int BlocksOf(int length) => (length + BlockBytes - 1) / BlockBytes;

        static long RecordBytes(int length) => HeaderBytes + 8L * BlocksOf(length) + length;

        static ulong HashOf(ref Header header) => ContentHash.Of(AsBytes(ref header).Slice(0, HeaderBytes - 8));

        static Span<byte> AsBytes(ref Header header) => MemoryMarshal.AsBytes(MemoryMarshal.CreateSpan(ref header, 1));
    }

    internal readonly struct FileVersionKey : IEquatable<FileVersionKey>
    {
        public readonly ulong A;
        public readonly ulong B;

        public FileVersionKey(ulong a, ulong b) => (A, B) = (a, b);

        public static FileVersionKey Of(string text) => new FileVersionKey(ContentHash.Of(Encoding.UTF8.GetBytes("A" + text)),
            ContentHash.Of(Encoding.UTF8.GetBytes("B" + text)));

        public bool Equals(FileVersionKey other) => A == other.A && B == other.B;

        public override bool Equals(object obj) => obj is FileVersionKey other && Equals(other);

        public override int GetHashCode() => A.GetHashCode();
    }
}
