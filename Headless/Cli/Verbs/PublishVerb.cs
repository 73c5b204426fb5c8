namespace FastPoints.Cli.Verbs;

public sealed class PublishVerb : Verb
{
    const int AskedFiles = 8; // Files of a server that are asked for: others are served the same way.

    readonly Argument<string> m_cloud = new("NAME.fastpoints")
    {
        Description = "A converted cloud, or the address where it lies already.",
    };

    readonly Flag m_single = new("--single",
        "Make a cloud of one file beside its texts, for hosts that limit the number of files, and check that.");
    readonly ValueOption<string?> m_output = new("--output", "OUT.fastpoints",
        "The folder to make, with --single.")
    { Aliases = { "-o" } };

    public PublishVerb() : base(new Command("publish", "Check that a web server can serve a converted cloud, or does."))
    {
        Command.Add(m_cloud, m_single, m_output);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints publish town.fastpoints", "is all there, and what does a server need?"),
        ("./fastpoints publish town.fastpoints --single -o web/town.fastpoints", "one file of points"),
        ("./fastpoints publish https://example.org/town.fastpoints", "does the server do what is needed?"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string path = parsed.GetRequiredValue(m_cloud);
        string? output = parsed.GetValue(m_output);
        if (parsed.GetValue(m_single) != (output != null))
            throw new UsageException("--single wants --output, and --output belongs to --single");
        OutputNames.RequireNewCloud(output, [path], run.Settings.IsForced);
        run.Begin([path]);
        if (output != null)
        {
            run.RunSteps(SingleFileStep.Run(path, output, run.Progress));
            path = output;
        }
        var problems = new List<string>();
        using var cloud = CloudFolder.Open(path);
        var files = FilesOf(cloud).ToList();
        long bytes = files.Sum(f => f.Bytes);
        run.WriteKeys = json =>
        {
            json.WriteInteger("files", files.Count);
            json.WriteInteger("bytes", bytes);
            json.WriteArray("problems", problems, json.WriteStringValue);
        };
        if (cloud.IsUnfinished)
            problems.Add("it is being built: its files will change their names");
        problems.AddRange(SourcePath.IsRemote(path) ? ProblemsOfServer(files) : ProblemsOfFolder(path, files));
        problems.ForEach(run.Out.WriteLine);
        run.Out.WriteLine(SourcePath.WithoutQuery(path) + ": " + NumberFormat.Count(files.Count, "file") + ", "
            + NumberFormat.Bytes(bytes) + ", the largest " + NumberFormat.Bytes(files.Max(f => f.Bytes)));
        if (problems.Count > 0)
            throw new PointCloudException(FailureCode.BadInput, SourcePath.WithoutQuery(path), -1,
                NumberFormat.Count(problems.Count, "problem"));
        run.Out.WriteLine(SourcePath.IsRemote(path)
            ? "Ranges, lengths and versions are as they should be: give this address as the path of a cloud."
            : "Copy the folder as it is to any server that answers ranges and sends the files uncompressed.");
    }

    static IEnumerable<(string Path, long Bytes)> FilesOf(CloudFolder cloud)
    {
        foreach (string name in new[] { StoreFormat.ManifestName, StoreFormat.SourcesName })
            if (SourcePath.Combine(cloud.FolderPath, name) is var text)
                yield return (text, StoreFile.SizeOf(text));
        // All containers are known with the pages.
        _ = cloud.EachTable().Count();
        foreach (var file in cloud.Files())
            yield return file;
        // What the source's headers said: not every cloud has it, and a server is not asked for what may be missing.
        foreach (string name in new[] { StoreFormat.FactsName, StoreFormat.RecordsName })
            if (Path.Combine(cloud.FolderPath, name) is var path && File.Exists(path))
                yield return (path, StoreFile.SizeOf(path));
    }

    static IEnumerable<string> ProblemsOfFolder(string path, List<(string Path, long Bytes)> files)
    {
        foreach (var (file, bytes) in files)
            if (!File.Exists(file))
                yield return file + " is missing";
            else if (StoreFile.SizeOf(file) is var size && size != bytes)
                yield return file + ": wanted " + NumberFormat.Count(bytes) + " bytes, got " + NumberFormat.Count(size);
        foreach (string other in Directory.EnumerateFiles(path, "*", SearchOption.AllDirectories)
            .Except(files.Select(f => f.Path)).Order(StringComparer.Ordinal))
            yield return other + " is no part of the cloud";
    }

    /// <summary>The last bytes of some files: what is wrong with an answer is its failure.</summary>
    static IEnumerable<string> ProblemsOfServer(List<(string Path, long Bytes)> files)
    {
        int step = Math.Max(1, files.Count / AskedFiles);
        for (int i = 0; i < files.Count; i += step)
        {
            var (path, bytes) = files[i];
            string? problem = null;
            try
            {
                var file = RemoteFile.Open(path);
                if (file.Length != bytes)
                    problem = "wanted " + NumberFormat.Count(bytes) + " bytes, got " + NumberFormat.Count(file.Length);
                else if (!file.HasVersion)
                    problem = "has neither ETag nor Last-Modified: what replaces it would be mixed with it";
                else
                    file.Read(bytes - 1, new byte[1]);
            }
            catch (PointCloudException e)
            {
                problem = e.What;
            }
            if (problem != null)
                yield return SourcePath.WithoutQuery(path) + ": " + problem;
        }
    }
}
