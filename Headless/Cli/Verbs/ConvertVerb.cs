namespace FastPoints.Cli.Verbs;

public sealed class ConvertVerb : Verb
{
    readonly Inputs m_files = new("FILE",
        "Point clouds, or folders of them. Several become one cloud with the attributes of all.");
    readonly ValueOption<string?> m_output = new("--output", "NAME.fastpoints",
        "The folder to make; a cloud of the same files that is there is replaced when the new one is whole.")
    { Aliases = { "-o" } };
    readonly Flag m_normals = new("--normals",
        "Also compute normals of the points from their 16 nearest neighbours: 2 bytes a point. A converted cloud gets them "
            + "without -o.");
    readonly ValueOption<string?> m_memory = new("--memory", "SIZE",
        "Resident memory that the process may take, such as 300MiB or 4GiB (default: 1GiB). What does not fit goes to "
            + "temporary files beside the target; 300MiB are enough for any cloud, and what is stored is the same.");

    readonly Flag m_report = new("--report",
        "Also build with every sampler and several spacings, and write their errors beside their times into NAME-samplers/: "
            + "CSV, SVG and report.html.");
    readonly Flag m_discard = new("--discard",
        "Do not go on with a build that was stopped, and keep nothing of this one when it is.");
    readonly CloudSettings m_cloud;

    public ConvertVerb() : base(new Command("convert",
        "Build the octree that is streamed from: every point, every attribute, nothing rounded."))
    {
        Command.Add(m_files, m_output, m_memory, m_normals);
        m_cloud = new CloudSettings(Command);
        Command.Add(m_report, m_discard);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints convert scan.las -o scan.fastpoints", "all attributes"),
        ("./fastpoints convert big.laz -o big.fastpoints --memory 300MiB", "in little memory; killed, the same line goes on"),
        ("./fastpoints convert *.las -o all.fastpoints --attributes Red,Green,Blue", "tiles as one cloud, colour only"),
        ("./fastpoints convert scan.las -o scan.fastpoints --report", "what each sampler costs and gains"),
        ("./fastpoints convert tiles/ -o all.fastpoints", "all clouds in a folder as one"),
        ("./fastpoints convert scan.fastpoints --normals", "add normals to a converted cloud"),
        ("./fastpoints convert scan.las -o ground.fastpoints --classes 2,9", "ground and water"),
        ("./fastpoints convert scan.fastpoints -o edited.fastpoints", "a cloud's edits as a cloud of their own"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var files = parsed.GetRequiredValue(m_files);
        if (parsed.GetValue(m_output) == null)
        {
            AddNormals(files, parsed, run);
            return;
        }
        var settings = m_cloud.Read(parsed);
        if (parsed.GetValue(m_memory) is { } memory)
            Memory.Limit(settings, memory);
        string output = parsed.GetValue(m_output)!;
        OutputNames.RequireFolderName(output);
        OutputNames.RefuseInputs(output, files);
        string samplers = Path.ChangeExtension(output, null) + "-samplers";
        if (parsed.GetValue(m_report))
            OutputNames.RefuseForeignFolder("a report", samplers, "pictures.csv", run.Settings.IsForced);
        files = run.Begin(files);
        using var reader = Open(files, m_cloud.ReadOptions(parsed));
        run.Warn(reader.Info);
        if (!run.Settings.IsForced)
            OutputNames.RefuseOtherCloud(output, reader);
        CloudSettings.RequireAttributes(settings, reader);
        run.IsDiscarding = parsed.GetValue(m_discard);
        using var filter = m_cloud.Filter(parsed, reader);
        var wanted = filter == null ? reader : new FilteredReader(reader, filter);
        var result = ConvertStep.Run([wanted], output, settings, run);
        run.Points.Add(reader.Info, filter == null && reader is not ConvertedReader ? result.PointsFound : reader.PointCount);
        if (result.PointsFound == 0 && reader.PointCount > 0)
            run.WarnEmpty(output, "left", reader.PointCount, reader.Info.BoundsClaimed, []);
        var normals = parsed.GetValue(m_normals) ? NormalsStep.Run(output, run) : null;
        run.WriteKeys = json =>
        {
            result.WriteKeys(json);
            normals?.WriteKeys(json);
        };
        run.Out.WriteLine(output + ": " + result.Describe());
        if (normals != null)
            run.Out.WriteLine("  " + normals.Describe());
        run.Out.WriteLine("  unit   " + SourceFacts.UnitOf(reader.Info.Crs.Units, result.Result.Manifest.BoundsGeo));
        StageTable.Of(run.Progress).Write(run.Out, "  ");
        if (!parsed.GetValue(m_report))
            return;
        new SamplerReport(wanted, samplers, settings, run).Write();
        run.Out.WriteLine(Path.Combine(samplers, "report.html"));
    }

    static PointReader Open(string[] files, ReadOptions options)
    {
        if (files is [var cloud] && CloudFolder.IsCloud(cloud))
        {
            var stored = ConvertedReader.OpenEdited(cloud);
            if (stored.Edits != null)
                return stored;
            stored.Dispose();
        }
        return PointReaders.Open(files, options);
    }

    void AddNormals(string[] files, ParseResult parsed, CliRun run)
    {
        if (files is not [var cloud] || !parsed.GetValue(m_normals) || !CloudFolder.IsCloud(cloud))
            throw new UsageException("--output: wanted NAME.fastpoints, the folder to make; only normals (--normals) of one "
                + "converted cloud need none");
        OutputNames.RefuseName(cloud);
        run.Begin(files);
        var normals = NormalsStep.Run(cloud, run);
        run.WriteKeys = normals.WriteKeys;
        run.Out.WriteLine(cloud + ": " + normals.Describe());
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }
}
