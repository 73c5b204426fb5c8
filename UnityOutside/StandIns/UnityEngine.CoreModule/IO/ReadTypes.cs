namespace Unity.IO.LowLevel.Unsafe;

/// <summary>One segment of a file, and where its bytes go.</summary>
public unsafe struct ReadCommand
{
    public void* Buffer;
    public long Offset;
    public long Size;
}

/// <summary>Commands that stay where they are until the read is done.</summary>
public unsafe struct ReadCommandArray
{
    public ReadCommand* ReadCommands;
    public int CommandCount;
}

public enum ReadStatus
{
    Complete = 0,
    InProgress = 1,
    Failed = 2,
    Truncated = 4,
    Canceled = 5,
}

public enum FileStatus { Closed = 0, Pending = 1, Open = 2, OpenFailed = 3 }

public enum FileState { Absent = 0, Exists = 1 }

public struct FileInfoResult
{
    public long FileSize;
    public FileState FileState;
}

public enum AssetLoadingSubsystem
{
    Other = 0,
    Texture = 1,
    VirtualTexture = 2,
    Mesh = 3,
    Audio = 4,
    Scripts = 5,
    EntitiesScene = 6,
    EntitiesStreamBinaryReader = 7,
    FileInfo = 8,
    ContentLoading = 9,
}
