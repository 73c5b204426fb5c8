namespace FastPoints.Cli.Cluster;

/// <summary>The folder of a task on the disk where it runs. A task that is stopped leaves it, and goes on from there if it runs
/// on this machine once more; a second one at the same time gets another folder.</summary>
sealed class TaskScratch : IDisposable
{
    const int MostCopies = 16;

    readonly FolderLock m_lock;
    readonly Timer m_renewal;

    TaskScratch(string folder, FolderLock taken)
    {
        (Folder, m_lock) = (folder, taken);
        m_renewal = new Timer(_ => m_lock.Renew(DateTime.UtcNow), null, FolderLock.RenewAfter, FolderLock.RenewAfter);
    }

    public string Folder { get; }

    public bool IsDone { get; set; } // What was made is in the store, and the folder goes.

    public static TaskScratch Take(string? root, string name)
    {
        string? owner = null;
        for (int copy = 1; copy <= MostCopies; copy++)
        {
            string folder = Path.Combine(root ?? Path.GetTempPath(), "fastpoints-" + name + (copy > 1 ? "-" + copy : ""));
            owner = FolderLock.TakeOrGetOwner(Path.Combine(folder, "task.lock"), out var taken);
            if (owner == null)
                return new TaskScratch(folder, taken);
        }
        throw new PointCloudException(FailureCode.WriteFailed, root ?? Path.GetTempPath(), -1,
            MostCopies + " copies of " + name + " are being built there, one by " + owner);
    }

    public string this[string name] => Path.Combine(Folder, name);

    public void Dispose()
    {
        m_renewal.Dispose();
        m_lock.Dispose();
        FileChanges.AwaitDeletes();
        try
        {
            if (IsDone)
                Directory.Delete(Folder, true);
            else if (!Directory.EnumerateFileSystemEntries(Folder).Any())
                Directory.Delete(Folder);
        }
        catch (Exception e) when (FileFailures.IsFileFailure(e))
        {
            // Another copy of the task has it.
        }
    }
}
