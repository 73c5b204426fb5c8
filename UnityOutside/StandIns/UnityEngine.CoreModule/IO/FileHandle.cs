namespace Unity.IO.LowLevel.Unsafe;

public readonly struct FileHandle
{
    internal static readonly HandleTable<OpenFile> All = new HandleTable<OpenFile>();

    readonly int m_Index;
    readonly int m_Version;

    internal FileHandle(OpenFile file) => (m_Index, m_Version) = All.Add(file);

    /// <summary>Done when the file is open, or could not be opened.</summary>
    public JobHandle JobHandle => Find("JobHandle").Opened;

    public FileStatus Status => Find("Status").Status;

    public bool IsValid() => All.Find(m_Index, m_Version) != null;

    /// <summary>Closes the file after the dependency and the reads begun; the handle is stale from now on.</summary>
    public JobHandle Close(JobHandle dependency = default)
    {
        OpenFile file = Find("Close");
        All.Remove(m_Index, m_Version);
        // Opening is waited for too: a file cannot be closed before it is open.
        JobHandle opened = JobScheduler.IsCompleted(file.Opened) ? dependency
            : JobHandle.CombineDependencies(dependency, file.Opened);
        return JobScheduler.CallAfter(opened, "FileHandle.Close", file.Close);
    }

    internal OpenFile Find(string what) => All.Find(m_Index, m_Version)
        ?? throw new InvalidOperationException($"FileHandle.{what}: the FileHandle is not valid, or the file was closed.");
}
