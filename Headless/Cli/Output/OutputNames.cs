namespace FastPoints.Cli.Output;

/// <summary>Names that an output may have: never that of an input, and none with another format's extension.</summary>
static class OutputNames
{
    const long MarkTicks = TimeSpan.TicksPerMillisecond * 10;

    static readonly string[] s_cloudExtensions =
    [
        ".las", ".laz", ".ply", ".e57", ".pts", ".ptx", ".pcd", ".xyz", ".pointcloud", StoreFormat.FolderExtension,
    ];

    static readonly StringComparison s_pathComparison =
        OperatingSystem.IsLinux() ? StringComparison.Ordinal : StringComparison.OrdinalIgnoreCase;

    static readonly string[] s_otherExtensions =
        [".png", ".jpg", ".jpeg", ".webp", ".gif", ".bmp", ".tif", ".tiff", ".html", ".csv"];

    public static void RefuseOtherKind(string option, string what, string path)
    {
        if (IsCloud(path) || s_otherExtensions.Any(extension => HasExtension(path, extension)))
            throw new UsageException(option + ": " + what + (IsCloud(path) ? " is no point cloud" : " is no such file")
                + ", got the name " + path);
    }

    public static void RequirePictureName(string path, string option = "--output")
    {
        RefuseUnwritable(path, option);
        if (Path.GetExtension(path) is { Length: > 0 } extension && !HasExtension(path, ".png"))
            throw new UsageException(option + ": a picture is a PNG file, NAME.png; " + extension + " is another kind: " + path);
    }

    public static void RefuseSame(string option, string path, string output)
    {
        if (RealPath(path).Equals(RealPath(output), s_pathComparison))
            throw new UsageException(option + " and --output name the same file: " + path);
    }

    static void RefuseUnwritable(string path, string option = "--output")
    {
        if (StandardStreams.IsOutput(path))
            throw new UsageException(option + ": standard output takes points (export, demo-cloud) and summaries only, got "
                + path);
        RefuseName(path);
    }

    public static void RefuseName(string path)
    {
        if (SourcePath.IsRemote(path))
            throw new UsageException("--output: nothing is written to servers, got " + SourcePath.WithoutQuery(path));
        if (NonUtf8Names.IsTemporaryLink(path))
            throw new UsageException(Path.GetFileName(path) + ": nothing is written under a name that is no UTF-8");
    }

    public static void RequireExportName(string path)
    {
        RefuseName(path);
        if (Path.GetExtension(path).ToLowerInvariant() is not (".las" or ".laz" or ".ply"))
            throw new UsageException("--output: wanted a name that ends in .las, .laz, .copc.laz or .ply, got " + path);
        if (Directory.Exists(path))
            throw new UsageException("--output: this is a folder: " + path);
    }

    public static void RequireFolderName(string path)
    {
        RefuseUnwritable(path);
        if (IsCloud(path) && !HasExtension(path, StoreFormat.FolderExtension))
            throw new UsageException("--output: convert makes a folder, NAME" + StoreFormat.FolderExtension
                + "; the verb export writes point cloud files: " + path);
        if (!IsCloud(path))
            RefuseOtherKind("--output", "a converted cloud", path);
    }

    public static void RefuseInputs(string output, IEnumerable<string> inputs)
    {
        RefuseName(output);
        string written = RealPath(output);
        foreach (string input in inputs.Where(i => !SourcePath.IsRemote(i)))
        {
            string read = RealPath(input);
            bool isInside = written.StartsWith(read + Path.DirectorySeparatorChar, s_pathComparison) && IsCloud(written);
            if (read.Equals(written, s_pathComparison) || isInside && File.Exists(written))
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
        RefuseUnwritable(path);
        RefuseOtherKind("--output", what, path);
        if (File.Exists(path))
            throw new UsageException("--output: " + what + " is a folder, and this is a file: " + path);
        if (!force)
            RefuseFilled(path, marker);
    }

    static void RefuseFilled(string path, string marker)
    {
        if (Directory.Exists(path) && Directory.EnumerateFileSystemEntries(path).Any()
            && !File.Exists(Path.Combine(path, marker)))
            throw new UsageException(path + " has other things in it: --output names another folder, --force writes there");
    }

    /// <summary>The name of a cloud to make of another one, if there is such a name; what is there is replaced by force
    /// only.</summary>
    public static void RequireNewCloud(string? path, string[] inputs, bool force)
    {
        if (path == null)
            return;
        RequireFolderName(path);
        RefuseInputs(path, inputs);
        if (!force && File.Exists(Path.Combine(path, StoreFormat.ManifestName)))
            throw new UsageException(path + " is a cloud already: --force replaces it");
        RefuseFilled(path, StoreFormat.ManifestName);
    }

    /// <summary>An existing cloud, finished or not, is replaced by one of the same files without asking, as a resumed or
    /// repeated conversion does, and by no other.</summary>
    public static void RefuseOtherCloud(string path, PointReader reader)
    {
        RefuseFilled(path, StoreFormat.ManifestName);
        foreach (string folder in new[] { path, Path.TrimEndingDirectorySeparator(path) + StoreFormat.UnfinishedSuffix })
        {
            string file = Path.Combine(folder, StoreFormat.ManifestName);
            if (!File.Exists(file))
                continue;
            var wanted = SourcesOf(reader);
            // An unfinished cloud may not know its sources yet.
            if (SourcesOf(folder, folder == path) is not { } there
                || there.Count == wanted.Count && there.Zip(wanted, IsSame).All(same => same))
                continue;
            throw new UsageException(folder + " holds " + (there.Count == 0 ? "something else" : "a cloud of " + Describe(there))
                + ": --force replaces it by one of " + Describe(wanted));
        }
    }

    /// <summary>Empty if they cannot be read; null if unfinished and without sources.</summary>
    static List<SourceEntry>? SourcesOf(string folder, bool isFinished)
    {
        try
        {
            var sources = StoredSources.Read(folder);
            return isFinished || sources.Count > 0 ? sources : null;
        }
        catch (PointCloudException)
        {
            return isFinished ? [] : null;
        }
    }

    static List<SourceEntry> SourcesOf(PointReader reader) => reader is TiledReader tiles
        ? Enumerable.Range(0, tiles.TileCount).Select(tiles.TileEntryOf).ToList()
        : [new() { Name = reader.Info.Path, FileBytes = reader.Info.FileBytes, HeadHash = reader.Info.HeadHash }];

    // Octrees count their bytes while they are read.
    static bool IsSame(SourceEntry a, SourceEntry b) => SourcePath.NameOf(a.Name) == SourcePath.NameOf(b.Name)
        && (a.FileBytes == b.FileBytes || SourceFolder.IsIndex(SourcePath.NameOf(b.Name)))
        && (a.HeadHash == b.HeadHash || a.HeadHash == 0);

    static string Describe(List<SourceEntry> sources) => SourcePath.NameOf(sources[0].Name)
        + (sources[0].FileBytes > 0 ? " (" + NumberFormat.Count(sources[0].FileBytes) + " bytes)" : "")
        + (sources.Count > 1 ? " and " + (sources.Count - 1) + " more" : "");

    /// <summary>Like clouds: files of other sources, and edited ones, are not replaced.</summary>
    public static void RefuseOtherExport(string path, PointReader reader, long mark)
    {
        if (!OutputFile.IsDevice(path) && File.Exists(path) && File.GetLastWriteTimeUtc(path).Ticks % MarkTicks != mark)
            throw new UsageException(path + " was made from other sources than " + Describe(SourcesOf(reader))
                + ", or was changed since: --force replaces it");
    }

    /// <summary>Encodes an export's sources in the digits below 10 ms of its time of writing: editing the file changes them,
    /// and its bytes need no room for it. If they are lost, as in copies, the file counts as changed.</summary>
    public static void MarkExport(string path, long mark)
    {
        if (OutputFile.IsDevice(path))
            return;
        var now = DateTime.UtcNow;
        OutputFile.WithFileErrors(path, () => File.SetLastWriteTimeUtc(path, now.AddTicks(mark - now.Ticks % MarkTicks)));
    }

    public static unsafe long MarkOf(PointReader reader)
    {
        string text = string.Join('\n', SourcesOf(reader)
            .Select(s => $"{SourcePath.NameOf(s.Name)}|{s.FileBytes}|{s.HeadHash:x}"));
        fixed (char* first = text)
            return (long)(ContentHash.Of(first, text.Length * sizeof(char)) % MarkTicks);
    }

    public static bool IsCloud(string path) => s_cloudExtensions.Any(extension => HasExtension(path, extension));

    static bool HasExtension(string path, string extension) =>
        path.TrimEnd('/', Path.DirectorySeparatorChar).EndsWith(extension, StringComparison.OrdinalIgnoreCase);

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

    static string RealPath(string path)
    {
        string full = Path.TrimEndingDirectorySeparator(Path.GetFullPath(path));
        try
        {
            FileSystemInfo info = Directory.Exists(full) ? new DirectoryInfo(full) : new FileInfo(full);
            full = info.ResolveLinkTarget(returnFinalTarget: true)?.FullName ?? full;
        }
        catch (IOException)
        {
            // A broken or circular link cannot be read as an input.
        }
        string? folder = Path.GetDirectoryName(full);
        return folder == null ? full : Path.Combine(RealPath(folder), Path.GetFileName(full));
    }
}
