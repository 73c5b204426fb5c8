namespace FastPoints.RepoTools.Layers;

/// <summary>Files of one room that name one another in a circle, so that none of them can be read or tested alone. A part is
/// given what it needs, not the whole that it is a part of. Constants are not in the IL, so what only they join is not
/// found.</summary>
public static class FileCycles
{
    private static readonly CSharpParseOptions s_options =
        CSharpParseOptions.Default.WithPreprocessorSymbols("FASTPOINTS_PHYSICS", "FASTPOINTS_AI", "FASTPOINTS_DOTS_PHYSICS");

    private static readonly (string Files, string Reason)[] s_kept =
    {
        ("Authoring/PointCloud.cs, Authoring/PointCloudOrigin.cs", "origins place clouds that set them; Unity wants a file each"),
        ("Reading/Tiles/TiledRead.cs, Reading/Tiles/TiledReader.cs", "a slot enters and leaves the tiles that its reader counts"),
        ("Drawing/Feeds/CloudFeed.cs, Drawing/Feeds/FileFeed.cs, Drawing/Feeds/FolderFeed.cs", "a feed opens the feed that fits"),
        ("E57/E57Section.cs, E57/E57Walk.cs", "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Las/LasHeader.cs, Las/LasPointFormat.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Reading/Blocks/AsciiLines.cs, Reading/Blocks/AsciiSegments.cs, Reading/Blocks/SegmentBlocks.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Reading/Blocks/BlockRead.cs, Reading/PointReader.cs, Reading/SourceTree.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Reading/Blocks/RecordReader.cs, Reading/Blocks/StridedRead.cs, Reading/SourceScan.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Sources/Copc/CopcHierarchy.cs, Sources/Copc/CopcReader.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Sources/Ept/EptHierarchy.cs, Sources/Ept/EptReader.cs, Sources/Ept/EptRecordRead.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Streaming/Loading/NodeFetch.cs, Streaming/Loading/NodeUploads.cs", "the queue and the uploads take from one another"),
        ("Text/Pcd/PcdLzfReader.cs, Text/Pcd/PcdReader.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
        ("Text/Ptx/DecodePtxJob.cs, Text/Ptx/PtxReader.cs",
            "a reader, its slots and its lists are one thing in files of a readable length"),
    };

    public static IEnumerable<string> Check(ModuleDefinition module, string folder) => Check(module, FilesIn(folder), s_kept
        .Where(k => File.Exists(Path.Combine(folder, k.Files.Split(", ")[0]))).Select(k => k.Files).ToList());

    public static IEnumerable<string> Check(ModuleDefinition module, IReadOnlyDictionary<string, string> fileOfType,
        IReadOnlyList<string> kept)
    {
        var named = new Dictionary<string, Dictionary<string, string>>();
        foreach (IlUse use in IlUses.Of(module).Where(u => u.Within != null))
        {
            foreach (TypeReference type in RoomOrder.Types(use.Member))
            {
                if (FileOf(use.Within!) is string from && FileOf(type) is string to && from != to && RoomOf(from) == RoomOf(to))
                    (named.TryGetValue(from, out var names) ? names : named[from] = new()).TryAdd(to, use.Site);
            }
        }
        Dictionary<string, HashSet<string>> reached = named.Keys.ToDictionary(f => f, f => Reach(f, named));
        List<string> circles = reached.Where(r => r.Value.Contains(r.Key)).Select(r => string.Join(", ", r.Value
            .Where(f => reached.TryGetValue(f, out var back) && back.Contains(r.Key)).Order(StringComparer.Ordinal)))
            .Distinct().ToList();
        foreach (string circle in circles.Except(kept))
        {
            string[] files = circle.Split(", ");
            yield return $"{circle} name one another: " + string.Join("; ", files.SelectMany(f => named[f]
                .Where(n => files.Contains(n.Key)).Select(n => $"{Path.GetFileName(n.Key)} in {n.Value}")));
        }
        foreach (string unused in kept.Except(circles))
            yield return $"{unused} need no exception";

        string? FileOf(TypeReference type)
        {
            TypeReference outer = type.GetElementType();
            while (outer.DeclaringType != null)
                outer = outer.DeclaringType;
            return fileOfType.GetValueOrDefault(outer.FullName.Split('`')[0]);
        }
    }

    private static string RoomOf(string file) => file[..(file.IndexOf('/') + 1)];

    internal static HashSet<string> Reach(string from, Dictionary<string, Dictionary<string, string>> named)
    {
        var reached = new HashSet<string>();
        var open = new Stack<string>(new[] { from });
        while (open.TryPop(out string? file))
        {
            foreach (string next in named.TryGetValue(file, out var names) ? names.Keys : Enumerable.Empty<string>())
            {
                if (reached.Add(next))
                    open.Push(next);
            }
        }
        return reached;
    }

    private static Dictionary<string, string> FilesIn(string folder)
    {
        var files = new Dictionary<string, string>();
        string[] sources = Directory.GetFiles(folder, "*.cs", SearchOption.AllDirectories);
        foreach (string file in sources.Order(StringComparer.Ordinal))
        {
            SyntaxNode root = CSharpSyntaxTree.ParseText(File.ReadAllText(file), s_options).GetRoot();
            foreach (BaseNamespaceDeclarationSyntax space in root.ChildNodes().OfType<BaseNamespaceDeclarationSyntax>())
            {
                foreach (MemberDeclarationSyntax member in space.Members)
                {
                    string? name = (member as BaseTypeDeclarationSyntax)?.Identifier.ValueText ??
                        (member as DelegateDeclarationSyntax)?.Identifier.ValueText;
                    files.TryAdd($"{space.Name}.{name}", Path.GetRelativePath(folder, file).Replace('\\', '/'));
                }
            }
        }
        return files;
    }
}
