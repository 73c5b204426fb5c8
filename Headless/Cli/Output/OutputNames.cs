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

    static readonly string[] s_others = [".png", ".jpg", ".jpeg", ".webp", ".gif", ".bmp", ".tif", ".tiff", ".html", ".csv"];

    public static void RefuseOther(string option, string what, string path)
    {
        if (IsCloud(path) || s_others.Any(ending => HasEnding(path, ending)))
            throw new UsageException(option + ": " + what + (IsCloud(path) ? " is no point cloud" : " is no such file")
                + ", got the name " + path);
    }

    public static void RefuseNoPicture(string path)
    {
        if (Path.GetExtension(path) is { Length: > 0 } ending && !HasEnding(path, ".png"))
            throw new UsageException("--output: a picture is a PNG file, NAME.png; " + ending + " is another kind: " + path);
    }

    public static void RefuseNoExport(string path)
    {
        if (!ExportCloud.CanWrite(path))
            throw new UsageException("--output: wanted a name that ends in .las, .laz, .copc.laz or .ply, got " + path);
        if (Directory.Exists(path))
            throw new UsageException("--output: this is a folder: " + path);
    }

    public static void RefuseFile(string path)
    {
        if (IsCloud(path) && !HasEnding(path, StoreFormat.FolderExtension))
            throw new UsageException("--output: convert makes a folder, NAME" + StoreFormat.FolderExtension
                + "; the verb export writes point cloud files: " + path);
        if (!IsCloud(path))
            RefuseOther("--output", "a converted cloud", path);
    }

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

    public static void RefuseForeign(string path, bool force)
    {
        if (!force && !OutputFile.IsDevice(path) && File.Exists(path) && !IsOwn(path))
            throw new UsageException(path + " already exists and was not made by this tool: --force replaces it");
    }

    /// <summary>The name of a folder for several files: new, empty, or one that the same verb has filled before.</summary>
    public static void RefuseForeignFolder(string what, string path, string marker, bool force)
    {
        RefuseOther("--output", what, path);
        if (File.Exists(path))
            throw new UsageException("--output: " + what + " is a folder, and this is a file: " + path);
        if (!force && Directory.Exists(path) && Directory.EnumerateFileSystemEntries(path).Any()
            && !File.Exists(Path.Combine(path, marker)))
            throw new UsageException(path + " has other things in it: --output names another folder, --force writes there");
    }

    public static bool IsCloud(string path) => s_clouds.Any(ending => HasEnding(path, ending));

    static bool HasEnding(string path, string ending) =>
        path.TrimEnd('/', Path.DirectorySeparatorChar).EndsWith(ending, StringComparison.OrdinalIgnoreCase);

    static bool IsOwn(string path)
    {
        var head = new byte[512];
        int bytes = 0;
        OutputFile.WithFileErrors(path, () =>
        {
            using var file = File.OpenRead(path);
            bytes = file.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
        });
        string text = Encoding.Latin1.GetString(head, 0, bytes);
        return bytes == 0 || text.Contains("FastPoints", StringComparison.Ordinal)
            || text.Contains("comment seeded terrestrial laser scan", StringComparison.Ordinal)
            || text.StartsWith('{') && text[1..].TrimStart().StartsWith("\"verb\":", StringComparison.Ordinal);
    }

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
