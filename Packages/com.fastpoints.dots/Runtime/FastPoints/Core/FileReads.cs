using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints
{
    internal static unsafe class FileReads
    {
        // Opens a file, reads and closes it. Read by its name, a file would stay open on macOS and Linux: it would be
        // read on after another has its name, and keep its place on the disk after it was deleted. Main thread.
        // Commands and their memory must stay valid until the read has ended; closed ends when the file is closed.
        public static ReadHandle BeginOneShot(string path, ReadCommand* commands, int count) =>
            BeginOneShot(path, commands, count, out _);

        public static ReadHandle BeginOneShot(string path, ReadCommand* commands, int count, out JobHandle closed)
        {
            var file = AsyncReadManager.OpenFileAsync(path);
            var read = AsyncReadManager.Read(file, new ReadCommandArray { ReadCommands = commands, CommandCount = count });
            closed = file.Close(read.JobHandle);
            return read;
        }
    }

    internal struct FilePiece
    {
        public string Path;

        // Of a remote one, if it is known.
        public RemoteFile Remote;
        public long OffsetBytes;
        public long LengthBytes;
    }
}
