namespace FastPoints.Cli.Output;

/// <summary>Names that an output may have: never that of an input, and none that promises another kind of file.</summary>
static class OutputNames
{
    static readonly string[] s_clouds =
    [
        ".las", ".laz", ".ply", ".e57", ".pts", ".ptx", ".pcd", ".xyz", ".pointcloud", StoreFormat.FolderExtension,
    ];

    static readonly StringComparison s_ofPaths =
        OperatingSystem.IsLinux() ? StringComparison.Ordinal : StringComparison.OrdinalIgnoreCase;

    /// <param name="option">The option that gives the name.</param>
    /// <param name="what">What is written there.</param>
    public static void RefuseCloud(string option, string what, string path)
    {
        if (IsCloud(path))
            throw new UsageException(option + ": " + what + " is no point cloud, got the name " + path);
    }

    /// <summary>The name of a folder that is converted into.</summary>
    public static void RefuseFile(string path)
    {
        if (IsCloud(path) && !HasEnding(path, StoreFormat.FolderExtension))
            throw new UsageException("--output: convert makes a folder, NAME" + StoreFormat.FolderExtension
                + ", and exports no files; got " + path);
    }

    /// <summary>Nothing is written over what is read: not by another spelling, nor through links.</summary>
    public static void RefuseInputs(string output, IEnumerable<string> inputs)
    {
        string written = Real(output);
        foreach (string input in inputs)
        {
            string read = Real(input);
            bool isInside = written.StartsWith(read + Path.DirectorySeparatorChar, s_ofPaths) && IsCloud(written);
            if (read.Equals(written, s_ofPaths) || isInside && File.Exists(written))
                throw new UsageException(output + " is an input, and would be overwritten");
        }
    }

    /// <summary>A scan of somebody's is not replaced by a made-up one.</summary>
    /// <param name="force">Do it all the same.</param>
    public static void RefuseForeign(string path, bool force)
    {
        if (!force && File.Exists(path) && !IsOwn(path))
            throw new UsageException(path + " already exists and was not made by this tool: --force replaces it");
    }

    static bool IsCloud(string path) => s_clouds.Any(ending => HasEnding(path, ending));

    static bool HasEnding(string path, string ending) =>
        path.TrimEnd('/', Path.DirectorySeparatorChar).EndsWith(ending, StringComparison.OrdinalIgnoreCase);

    /// <summary>Whether the head of a LAS, LAZ or PLY file names this tool.</summary>
    static bool IsOwn(string path)
    {
        var head = new byte[512];
        int bytes = 0;
        OutputFile.Guarded(path, () =>
        {
            using var file = File.OpenRead(path);
            bytes = file.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
        });
        string text = Encoding.Latin1.GetString(head, 0, bytes);
        return text.Contains("FastPoints", StringComparison.Ordinal)
            || text.Contains("comment seeded terrestrial laser scan", StringComparison.Ordinal);
    }

    /// <summary>The full path with all links followed.</summary>
    static string Real(string path)
    {
        string full = Path.TrimEndingDirectorySeparator(Path.GetFullPath(path));
        try
        {
            FileSystemInfo info = Directory.Exists(full) ? new DirectoryInfo(full) : new FileInfo(full);
            full = info.ResolveLinkTarget(returnFinalTarget: true)?.FullName ?? full;
        }
        catch (IOException)
        {
            // A link that leads nowhere, or in a circle, is no input that could be read.
        }
        string? folder = Path.GetDirectoryName(full);
        return folder == null ? full : Path.Combine(Real(folder), Path.GetFileName(full));
    }
}
