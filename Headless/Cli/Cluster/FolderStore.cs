namespace FastPoints.Cli.Cluster;

sealed partial class FolderStore(string name) : ObjectStore(name)
{
    /// <summary>Unfinished files: none is left among the cloud's when a task is killed.</summary>
    const string IncomingFolder = WorkFolder + "incoming";

    static int s_number;

    public override int Lanes => 1;
    public override string CloudPath => Name;

    public override void Put(string name, string path) => OutputFile.WithFileErrors(PathOf(name), () =>
    {
        string incoming = Path.Combine(PathOf(IncomingFolder), string.Create(CultureInfo.InvariantCulture,
            $"{Environment.MachineName}-{Environment.ProcessId}-{Interlocked.Increment(ref s_number)}"));
        Directory.CreateDirectory(Path.GetDirectoryName(incoming)!);
        Directory.CreateDirectory(Path.GetDirectoryName(PathOf(name))!);
        try
        {
            if (!TryLink(path, incoming))
                Copy(path, incoming);
            File.Move(incoming, PathOf(name), overwrite: true);
        }
        finally
        {
            // Nothing is moved if both are links to one file.
            File.Delete(incoming);
        }
    });

    /// <summary>On one file system a second name costs nothing.</summary>
    static bool TryLink(string path, string to) => !OperatingSystem.IsWindows() && Link(path, to) == 0;

    static void Copy(string path, string to)
    {
        using var from = File.OpenRead(path);
        using var file = new FileStream(to, FileMode.Create, FileAccess.Write, FileShare.None, 1);
        from.CopyTo(file, 4 << 20);
        file.Flush(flushToDisk: true);
    }

    public override string? ReadText(string name) => StoreFile.TryReadText(PathOf(name), out string text) ? text : null;

    public override void CopyRangeTo(string name, long offset, long count, Stream to)
    {
        var buffer = new byte[(int)Math.Min(count, 4 << 20)];
        try
        {
            using var from = File.OpenRead(PathOf(name));
            from.Position = offset;
            for (int got; count > 0; count -= got)
            {
                got = from.Read(buffer, 0, (int)Math.Min(count, buffer.Length));
                if (got == 0)
                    throw Failure(FailureCode.Truncated, name, "wanted " + count + " bytes more");
                to.Write(buffer, 0, got);
            }
        }
        catch (Exception e) when (FileFailures.IsFileFailure(e))
        {
            throw FileFailures.ReadFailure(PathOf(name), e);
        }
    }

    public override string EnsureLocal(string name, string folder) => PathOf(name);

    public override IEnumerable<(string Name, long Bytes)> List(string prefix)
    {
        var under = new DirectoryInfo(PathOf(prefix));
        return !under.Exists ? [] : under.EnumerateFiles("*", SearchOption.AllDirectories).Select(file =>
            (Path.GetRelativePath(Name, file.FullName).Replace(Path.DirectorySeparatorChar, '/'), file.Length));
    }

    public override void Delete(IEnumerable<string> names)
    {
        foreach (string name in names)
            OutputFile.WithFileErrors(PathOf(name), () => File.Delete(PathOf(name)));
        string work = PathOf(WorkFolder);
        if (Directory.Exists(work) && !Directory.EnumerateFiles(work, "*", SearchOption.AllDirectories).Any())
            Directory.Delete(work, true);
    }

    public override void MakeFolders(params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
            OutputFile.MakeFolder(PathOf(name));
    }

    string PathOf(string name) => Path.Combine(Name, name);

    [LibraryImport("libc", EntryPoint = "link", StringMarshalling = StringMarshalling.Utf8)]
    private static partial int Link(string path, string to);
}
