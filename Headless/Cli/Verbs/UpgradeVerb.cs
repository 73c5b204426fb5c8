using FastPoints.Cli.Upgrade;

namespace FastPoints.Cli.Verbs;

public sealed class UpgradeVerb : Verb
{
    readonly Argument<string> m_cloud = new("NAME.fastpoints")
    {
        Description = "A converted cloud of version " + OldHeader.Version + ".",
    };
    readonly ValueOption<string?> m_output = new("--output", "OTHER.fastpoints",
        "Another folder to make (default: the cloud is replaced when the new one is whole; both are on the disk until then).")
    { Aliases = { "-o" } };

    public UpgradeVerb() : base(new Command("upgrade",
        "Make a cloud that an older version converted one of this version: its points, without its sources."))
    {
        Command.Add(m_cloud, m_output);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints upgrade town.fastpoints", "in its place"),
        ("./fastpoints upgrade old/town.fastpoints -o town.fastpoints", "the old one stays"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string cloud = Path.TrimEndingDirectorySeparator(parsed.GetRequiredValue(m_cloud));
        string? output = parsed.GetValue(m_output);
        OutputNames.RequireNewCloud(output, [cloud], run.Settings.IsForced);
        run.Begin([cloud]);
        if (SourcePath.IsRemote(cloud) || !File.Exists(Path.Combine(cloud, StoreFormat.ManifestName)))
            throw new PointCloudException(FailureCode.NotFound, cloud, -1, "wanted a folder of this machine with "
                + StoreFormat.ManifestName);
        long points = 0, bytesBefore = BytesOf(cloud), bytesAfter = bytesBefore;
        bool isNew = OldCloud.VersionOf(cloud) == StoreFormat.Version;
        if (isNew && output != null)
            throw new PointCloudException(FailureCode.Unsupported, cloud, -1, "is of version " + StoreFormat.Version
                + " already: copy it");
        if (!isNew)
            run.RunSteps(UpgradeStep.Run(cloud, output ?? cloud, run.Progress, (found, bytes) =>
                (points, bytesAfter) = (found, bytes)));
        string made = output ?? cloud;
        if (isNew)
            using (var folder = CloudFolder.Open(cloud))
                points = folder.Manifest.Points;
        int files = Directory.GetFiles(made, "*", SearchOption.AllDirectories).Length;
        run.WriteKeys = json =>
        {
            json.WriteInteger("points", points);
            json.WriteInteger("files", files);
            json.WriteInteger("bytesBefore", bytesBefore);
            json.WriteInteger("bytesAfter", bytesAfter);
        };
        run.Out.WriteLine(made + ": " + (isNew ? "is of version " + StoreFormat.Version + " already"
            : NumberFormat.Count(points, "point") + " in " + NumberFormat.Count(files, "file") + ", "
            + NumberFormat.Bytes(bytesAfter) + ", before " + NumberFormat.Bytes(bytesBefore)));
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }

    static long BytesOf(string folder) =>
        Directory.GetFiles(folder, "*", SearchOption.AllDirectories).Sum(f => new FileInfo(f).Length);
}
