using System;
using System.Threading.Tasks;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints
{
    // One file that is not on this machine, as it was when it was opened: what comes from another version of it is refused.
    internal abstract class RemoteFile : IRangeSource
    {
        public const int HeadBytes = 64 << 10;

        // Smaller files are soon here as a whole: they are sampled like those of this machine. Of larger ones a range costs a
        // request.
        public static long MaxSmallFileBytes = 32 << 20;

        // Who opens addresses: HttpFile, which registers itself.
        public static IRemoteFiles Files;

        // For messages: signatures are left out.
        public abstract string Name { get; }

        public abstract long Length { get; }

        // Another value, another version of the file.
        public abstract string Identity { get; }

        // Without, only another length tells that it is another file.
        public abstract bool HasVersion { get; }

        // Seconds that an answer takes to begin; 0 if none was seen yet.
        public abstract double RoundTrip { get; }

        // Ranges no farther apart are brought sooner by one request than by two.
        public abstract int GapBytes { get; }

        // Waits: on pool threads and in the command line alone. headBytes: so many of a new file come with it.
        public static RemoteFile Open(string address, int headBytes = HeadBytes) => FilesFor(address).Open(address, headBytes);

        // The one that was opened last, or null.
        public static RemoteFile Find(string address) => FilesFor(address).Find(address);

        // A file that another describes, so that nothing is asked before its first range: its length, and a text that is another
        // for other content. Any thread; it does not wait.
        public static RemoteFile Of(string address, long length, string version) =>
            FilesFor(address).Of(address, length, version);

        // Frees what came with opening it.
        public abstract void DropHead();

        // The next Open asks the server.
        public abstract void Doubt();

        // What came of it was wrong: it is asked for again.
        public abstract void DropCached();

        // Into memory of the read's own, which the caller disposes. Any thread.
        public RemoteRead Begin(long offset, long bytes, int rank = 0) => Begin(new RemoteRead(this, offset, bytes, rank));

        // Into the commands' buffers, which live until the read is done or cancelled. The commands themselves may go.
        public unsafe RemoteRead Begin(ReadCommand* commands, int count, int rank = 0) =>
            Begin(new RemoteRead(this, commands, count, rank));

        // Waits, like Open. Throws what the read fails with.
        public unsafe void Read(long offset, Span<byte> into)
        {
            if (into.Length == 0 || TryReadHead(offset, into))
                return;
            fixed (byte* first = into)
            {
                var command = new ReadCommand { Buffer = first, Offset = offset, Size = into.Length };
                using var read = Begin(&command, 1, int.MinValue);
                read.Await();
            }
        }

        public abstract Task Fetch(long offset, long count, byte[] into, Func<int, bool> arrived);

        protected abstract RemoteRead Begin(RemoteRead read);

        protected abstract bool TryReadHead(long offset, Span<byte> into);

        static IRemoteFiles FilesFor(string address) => Files ?? throw new PointCloudException(FailureCode.Unsupported,
            SourcePath.WithoutQuery(address), -1, "this program reads no files of web servers");
    }

    internal interface IRemoteFiles
    {
        RemoteFile Open(string address, int headBytes);

        RemoteFile Find(string address);

        RemoteFile Of(string address, long length, string version);
    }
}
