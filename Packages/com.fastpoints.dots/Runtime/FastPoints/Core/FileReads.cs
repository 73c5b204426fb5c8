using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Core
{
    /// <summary>Reads of files that are read once, or whose names other files may have later.</summary>
    internal static unsafe class FileReads
    {
        /// <summary>Begins a read that opens its file and closes it again. Read by its name, a file would stay open on macOS and
        /// Linux: it would be read on after another has its name, and keep its place on the disk after it was deleted. Main
        /// thread.</summary>
        /// <param name="commands">They stay where they are until the read has ended, as does the memory that they name.</param>
        public static ReadHandle BeginOneShot(string path, ReadCommand* commands, int count) =>
            BeginOneShot(path, commands, count, out _);

        /// <param name="closed">Ends when nothing has the file open any more.</param>
        public static ReadHandle BeginOneShot(string path, ReadCommand* commands, int count, out JobHandle closed)
        {
            var file = AsyncReadManager.OpenFileAsync(path);
            var read = AsyncReadManager.Read(file, new ReadCommandArray { ReadCommands = commands, CommandCount = count });
            closed = file.Close(read.JobHandle);
            return read;
        }
    }
}
