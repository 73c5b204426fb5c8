namespace Unity.IO.LowLevel.Unsafe;

/// <summary>Reads files into native memory on threads of its own.</summary>
public static unsafe partial class AsyncReadManager
{
    /// <summary>Opens the file if it is not open since a read before, and reads the commands one after the other. The commands
    /// and their memory must stay until the read is done.</summary>
    public static ReadHandle Read(string filename, ReadCommand* readCmds, uint readCmdCount, string assetName = "",
        ulong typeID = 0, AssetLoadingSubsystem subsystem = AssetLoadingSubsystem.Scripts)
    {
        if (filename == null)
            throw new ArgumentNullException(nameof(filename));
        var request = ReadRequest.Take(filename, null, readCmds, checked((int)readCmdCount));
        request.Enqueue();
        return new ReadHandle(request);
    }

    /// <summary>The result's memory must stay until the read is done.</summary>
    public static ReadHandle GetFileInfo(string filename, FileInfoResult* result)
    {
        if (result == null)
            throw new NullReferenceException("GetFileInfo must have a valid FileInfoResult to write into.");
        var request = ReadRequest.Take(filename, null, null, 0);
        request.Info = result;
        request.Enqueue();
        return new ReadHandle(request);
    }

    public static ReadHandle Read(in FileHandle fileHandle, ReadCommandArray readCmdArray)
    {
        var request = ReadRequest.Take(null, fileHandle.Find("Read"), readCmdArray.ReadCommands, readCmdArray.CommandCount);
        request.Enqueue();
        return new ReadHandle(request);
    }

    /// <summary>Reads what the commands say when <paramref name="dependency"/> is done.</summary>
    public static ReadHandle ReadDeferred(in FileHandle fileHandle, ReadCommandArray* readCmdArray, JobHandle dependency)
    {
        var request = ReadRequest.Take(null, fileHandle.Find("ReadDeferred"), null, 0);
        JobScheduler.CallAfter(dependency, "AsyncReadManager.ReadDeferred", () => request.EnqueueDeferred(readCmdArray));
        return new ReadHandle(request);
    }

    /// <summary>Begins to open a file; reads on the handle may be begun at once.</summary>
    public static FileHandle OpenFileAsync(string fileName)
    {
        if (fileName == null)
            throw new ArgumentNullException(nameof(fileName));
        if (fileName.Length == 0)
            throw new InvalidOperationException("FileName is empty");
        return new FileHandle(OpenFile.Begin(fileName));
    }
}
