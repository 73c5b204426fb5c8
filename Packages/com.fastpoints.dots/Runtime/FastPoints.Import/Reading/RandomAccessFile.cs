using System;
using System.IO;
using System.Text;

namespace FastPoints.Reading
{
    internal static class FileFailures
    {
        // Windows, and runtimes on it, may refuse paths from this length on, and say that something is missing.
        const int LongPath = 260;

        public static bool IsFileFailure(Exception exception) =>
            exception is IOException || exception is UnauthorizedAccessException || exception is NotSupportedException
            || exception is ArgumentException || exception is System.Security.SecurityException;

        public static PointCloudException ReadFailure(string path, Exception cause) =>
            Failure(path, cause, FailureCode.ReadFailed, "cannot be read");

        public static PointCloudException WriteFailure(string path, Exception cause) => FileChanges.IsDiskFull(cause)
            ? new PointCloudException(FailureCode.DiskFull, path, -1, "the disk is full", cause)
            : Failure(path, cause, FailureCode.WriteFailed, "cannot be written");

        static PointCloudException Failure(string path, Exception cause, FailureCode fallback, string what)
        {
            if (cause is FileNotFoundException || cause is DirectoryNotFoundException)
                return new PointCloudException(FailureCode.NotFound, path, -1, "no such file or folder" + (path.Length < LongPath
                    ? "" : ": the path has " + path.Length + " characters, where Windows takes " + (LongPath - 1)), cause);
            if (cause is UnauthorizedAccessException || cause is System.Security.SecurityException)
                return new PointCloudException(FailureCode.AccessDenied, path, -1, what + ": permission denied", cause);
            return new PointCloudException(fallback, path, -1, what + ": " + cause.Message.Replace('\n', ' '), cause);
        }
    }

    // A file whose header is being read: small managed reads at any offset, never beyond the file's real size. The stream is
    // open between the first read and Dispose; a later read opens it again. AsyncReadManager reads the points instead. Remote
    // files are read a window at a time, which waits: not on an editor's or a player's main thread.
    internal sealed class RandomAccessFile : IDisposable
    {
        const int StreamBufferBytes = 16 * 1024;
        const int WindowBytes = 64 << 10;

        internal const long NoSuchFile = -1;

        readonly RemoteFile m_remote;
        FileStream m_stream;
        byte[] m_window = Array.Empty<byte>();
        long m_windowOffset;

        RandomAccessFile(string path, long length, RemoteFile remote = null)
        {
            Path = path;
            Length = length;
            m_remote = remote;
        }

        public string Path { get; }
        public long Length { get; }

        // NotFound for a folder or a missing file; Truncated for an empty file, a pipe or a device.
        public static RandomAccessFile Open(string path)
        {
            if (string.IsNullOrEmpty(path))
                throw new PointCloudException(FailureCode.NotFound, "(no path)", -1, "no file was named");
            if (SourcePath.IsRemote(path))
                return OfRemote(path);
            try
            {
                if (Directory.Exists(path))
                    throw new PointCloudException(FailureCode.NotFound, path, -1, "is a folder, wanted a file");
                // The size is queried before anything is opened: opening a pipe would wait for its writer, and pipes and
                // devices have no size.
                var info = new FileInfo(path);
                if (!info.Exists)
                    throw new PointCloudException(FailureCode.NotFound, path, -1, "no such file");
                long length = LengthOf(info);
                if (length == 0)
                    throw Empty(path, " (an empty file, a pipe or a device)");
                var source = new RandomAccessFile(path, length);
                source.Stream();
                return source;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.ReadFailure(path, e);
            }
        }

        static RandomAccessFile OfRemote(string address)
        {
            var remote = RemoteFile.Open(address);
            return remote.Length > 0 ? new RandomAccessFile(address, remote.Length, remote) : throw Empty(address, "");
        }

        static PointCloudException Empty(string path, string kind) =>
            new PointCloudException(FailureCode.Truncated, path, -1, "wanted a point cloud, got 0 bytes" + kind);

        internal static long LengthOf(string path)
        {
            if (path == null)
                return NoSuchFile;
            if (SourcePath.IsRemote(path))
                return LengthOfRemote(path);
            try
            {
                var file = new FileInfo(path);
                return file.Exists ? LengthOf(file) : NoSuchFile;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                return NoSuchFile;
            }
        }

        static long LengthOfRemote(string address)
        {
            try
            {
                return RemoteFile.Open(address).Length;
            }
            catch (PointCloudException e) when (e.Code == FailureCode.NotFound)
            {
                return NoSuchFile;
            }
        }

        // .NET returns the length of a link, not of its target.
        static long LengthOf(FileInfo file)
        {
            if ((file.Attributes & FileAttributes.ReparsePoint) == 0)
                return file.Length;
            using var linked = FileChanges.OpenToRead(file.FullName, StreamBufferBytes);
            return linked.CanSeek ? linked.Length : 0;
        }

        // Throws Truncated, before allocating, if the file is too short. The field names the bytes in messages.
        public ByteReader Read(long offset, int count, string field)
        {
            CheckRange(offset, count, field);
            return ReadUpTo(offset, count);
        }

        public void Read(long offset, byte[] into, int count, string field)
        {
            CheckRange(offset, count, field);
            ReadInto(into, offset, count);
        }

        void CheckRange(long offset, int count, string field)
        {
            if (offset < 0 || offset > Length || count > Length - offset)
                throw PointCloudException.Wanted(FailureCode.Truncated, Path, offset, field, count + " bytes",
                    Math.Max(0, Math.Min(Length - offset, Length)) + " before the end of the file");
        }

        public ByteReader ReadUpTo(long offset, int count)
        {
            long available = offset < 0 || offset >= Length ? 0 : Math.Min(count, Length - offset);
            var bytes = new byte[Math.Max(0, available)];
            ReadInto(bytes, offset, bytes.Length);
            return new ByteReader(bytes, Path, offset);
        }

        void ReadInto(byte[] bytes, long offset, int count)
        {
            if (m_remote != null)
            {
                ReadRemote(offset, new Span<byte>(bytes, 0, count));
                return;
            }
            int got = 0;
            try
            {
                var stream = Stream();
                if (count > 0)
                    stream.Position = offset;
                while (got < count)
                {
                    int read = stream.Read(bytes, got, count - got);
                    if (read == 0)
                        throw PointCloudException.Wanted(FailureCode.ReadFailed, Path, offset + got, "the file became shorter",
                            count + " bytes", got);
                    got += read;
                }
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.ReadFailure(Path, e);
            }
        }

        // The file's beginning came with opening it.
        void ReadRemote(long offset, Span<byte> into)
        {
            if (into.Length > WindowBytes || offset + into.Length <= RemoteFile.HeadBytes)
            {
                m_remote.Read(offset, into);
                return;
            }
            if (offset < m_windowOffset || offset + into.Length > m_windowOffset + m_window.Length)
            {
                // A table at the file's end is read from its end as well as from its start.
                m_windowOffset = Math.Min(offset, Math.Max(0, Length - WindowBytes));
                m_window = new byte[(int)Math.Min(WindowBytes, Length - m_windowOffset)];
                m_remote.Read(m_windowOffset, m_window);
            }
            new ReadOnlySpan<byte>(m_window, (int)(offset - m_windowOffset), into.Length).CopyTo(into);
        }

        public void Dispose()
        {
            m_stream?.Dispose();
            m_stream = null;
            m_window = Array.Empty<byte>();
        }

        FileStream Stream() => m_stream ??= FileChanges.OpenToRead(Path, StreamBufferBytes);
    }

    /// <summary>Reads little-endian fields of a piece of a file, addressed by their offset in the piece. A field outside the
    /// piece is a failure that names the byte in the file.</summary>
    internal readonly struct ByteReader
    {
        public readonly byte[] Bytes;
        public readonly string Path;
        public readonly long FileOffset;

        public ByteReader(byte[] bytes, string path, long fileOffset)
        {
            Bytes = bytes;
            Path = path;
            FileOffset = fileOffset;
        }

        public int Length => Bytes.Length;

        public bool Has(int at, int count) => at >= 0 && count >= 0 && count <= Bytes.Length - at;

        public byte UInt8(int at, string field) => Bytes[Start(at, 1, field)];

        public ushort UInt16(int at, string field)
        {
            int i = Start(at, 2, field);
            return (ushort)(Bytes[i] | Bytes[i + 1] << 8);
        }

        public uint UInt32(int at, string field)
        {
            int i = Start(at, 4, field);
            return (uint)(Bytes[i] | Bytes[i + 1] << 8 | Bytes[i + 2] << 16 | Bytes[i + 3] << 24);
        }

        public int Int32(int at, string field) => (int)UInt32(at, field);

        public ulong UInt64(int at, string field)
        {
            Start(at, 8, field);
            return UInt32(at, field) | (ulong)UInt32(at + 4, field) << 32;
        }

        public double Float64(int at, string field) => BitConverter.Int64BitsToDouble((long)UInt64(at, field));

        // Up to the first zero byte, without blanks at the end. Anything but printable ASCII becomes '?', so that it
        // prints as one line.
        public string Text(int at, int count, string field)
        {
            int start = Start(at, count, field);
            var text = new StringBuilder(count);
            for (int i = start; i < start + count && Bytes[i] != 0; i++)
                text.Append(Bytes[i] >= 32 && Bytes[i] < 127 ? (char)Bytes[i] : '?');
            return text.ToString().TrimEnd(' ');
        }

        int Start(int at, int count, string field)
        {
            if (!Has(at, count))
                throw PointCloudException.Wanted(FailureCode.Truncated, Path, FileOffset + at, field, count + " bytes",
                    Math.Max(0, Bytes.Length - (long)at));
            return at;
        }
    }
}
