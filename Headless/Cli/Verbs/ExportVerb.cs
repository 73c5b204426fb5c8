namespace FastPoints.Cli.Verbs;

public sealed class ExportVerb : Verb
{
    readonly Inputs m_clouds = new("CLOUD",
        "A converted cloud, or point clouds and folders of them, of which several become one file.");
    readonly ValueOption<string> m_output = new("--output", "OUT.las|.laz|.copc.laz|.ply",
        "The file to write. LAS and LAZ keep the point format, grid and records of a LAS source; COPC has point format 6, 7 "
            + "or 8 and an octree of its own, by way of temporary files in OUT.copc.laz.octree.")
    { Aliases = { "-o" }, Required = true };
    readonly ValueOption<string[]> m_clip = new("--clip", "x,y,z,X,Y,Z",
        "Only points in the box between two corners in the file's coordinates, faces included, or in any of several.");
    readonly ValueOption<string[]> m_clipLocal = new("--clip-local", "x,y,z,X,Y,Z",
        "The same, counted from the least corner of the cloud's bounds.");
    readonly ValueOption<string[]> m_cut = new("--cut", "x,y,z,X,Y,Z", "No points in the box.");
    readonly Option<long?> m_level = Counts.Optional("--level",
        "Only the nodes of an octree up to this level, of which 0 is the root: the source's, or for .copc.laz "
        + "the file's.", min: 0);
    readonly Option<long?> m_budget = Counts.Optional("--budget",
        "At most so many points, spread over all: an octree's first levels, or an even share.");
    readonly ValueOption<string?> m_attributes = new("--attributes", "A,B,...",
        "Attributes to keep beside the position (default: all).");
    readonly ValueOption<string?> m_memory = new("--memory", "SIZE",
        "For .copc.laz: resident memory that the process may take, as of convert (default: 1GiB).");
    readonly Flag m_asStored = new("--as-stored", "Without the edits of a converted cloud.");
    readonly FilterSettings m_filter;
    readonly SourceSettings m_source;

    public ExportVerb()
        : base(new Command("export", "Points out again as LAS, LAZ, COPC or PLY: all of a cloud, or a part of it."))
    {
        Command.Add(m_clouds, m_output, m_clip, m_clipLocal, m_cut);
        m_filter = new FilterSettings(Command);
        Command.Add(m_level, m_budget, m_attributes, m_memory, m_asStored);
        m_source = new SourceSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints export scan.fastpoints -o scan.laz", "all points, all attributes"),
        ("./fastpoints export scan.las -o scan.copc.laz", "for viewers that stream COPC"),
        ("./fastpoints export scan.copc.laz -o part.laz --clip-local 0,0,0,50,50,20", "what is in a box"),
        ("./fastpoints export tiles/ -o ground.las --classes 2,9", "ground and water of many tiles as one file"),
        ("./fastpoints export scan.las -o roofs.laz --polygon town.geojson --where 'Classification == 6 && Z > 40'",
            "buildings of a town"),
        ("./fastpoints export scan.fastpoints -o thin.ply --budget 1M", "a million points, spread evenly"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var clouds = parsed.GetRequiredValue(m_clouds);
        string output = parsed.GetRequiredValue(m_output);
        string file = run.Standard.FileOf(output);
        OutputNames.RequireExportName(file);
        var settings = new ExportSettings
        {
            Level = parsed.GetValue(m_level) is { } level ? Counts.ToInt(level) : -1,
            Budget = parsed.GetValue(m_budget) ?? 0,
            Attributes = parsed.GetValue(m_attributes)?.Split(',', StringSplitOptions.RemoveEmptyEntries),
        };
        if (parsed.GetValue(m_memory) is { } memory)
            settings.MemoryBytes = Memory.ForBuild(memory);
        clouds = run.Begin(clouds, output);
        using var reader = clouds is not [var only] || !CloudFolder.IsCloud(only)
            ? PointReaders.Open(clouds, m_source.Read(parsed))
            : parsed.GetValue(m_asStored) ? ConvertedReader.Open(only) : ConvertedReader.OpenEdited(only);
        run.Warn(reader.Info);
        // Before the bytes of an octree are counted.
        long mark = OutputNames.MarkOf(reader);
        if (!run.Settings.IsForced)
            OutputNames.RefuseOtherExport(file, reader, mark);
        settings.Clips =
        [
            .. (parsed.GetValue(m_clip) ?? []).Select(box => PictureSettings.Box("--clip", box, false)),
            .. (parsed.GetValue(m_clipLocal) ?? []).Select(box => Local(PictureSettings.Box("--clip-local", box, false), reader)),
            .. (parsed.GetValue(m_cut) ?? []).Select(box => PictureSettings.Box("--cut", box, true)),
        ];
        if (settings.Attributes?.FirstOrDefault(a => !reader.Info.Schema.Has(a)) is { } unknown)
            throw new UsageException("--attributes: " + reader.Info.ShownPath + " has no " + unknown + "; it has "
                + string.Join(", ", reader.Info.Schema.Select(a => a.Name)));
        using var filter = m_filter.Read(parsed, reader);
        if (filter?.EveryNth > 1 && CopcExport.IsNamed(file))
            throw new UsageException("--every-nth: COPC has its points in another order: wanted --budget or --level");
        settings.Filter = filter;
        ExportResult? result = null;
        run.RunSteps(ExportCloud.Run(reader, file, settings, r => result = r, run.Progress));
        OutputNames.MarkExport(file, mark);
        run.Standard.Send(output);
        run.Warn(reader.Info);
        run.Report(reader.Info.Losses);
        bool isWhole = settings.Level < 0 && settings.Budget == 0 && settings.Clips.Count == 0 && filter == null
            && reader is not ConvertedReader { Edits: not null };
        run.Points.Add(reader.Info, isWhole ? result!.PointsRead : reader.PointCount);
        if (result!.Points == 0 && reader.PointCount > 0)
            run.WarnEmpty(output, "left", reader.PointCount, reader.Info.BoundsClaimed, settings.Clips);
        WriteResult(result!, output, run);
    }

    static ClipBox Local(ClipBox box, PointReader reader)
    {
        var bounds = reader.Info.BoundsClaimed;
        if (!reader.Info.HasBoundsClaimed || !bounds.IsFinite)
            throw new UsageException("--clip-local: " + reader.Info.ShownPath + " does not say where it begins: wanted --clip");
        box.CenterWorld += bounds.Min;
        return box;
    }

    static void WriteResult(ExportResult result, string output, CliRun run)
    {
        foreach (string warning in result.Warnings)
            run.Warn(output + ": " + warning);
        run.Report(result.Losses);
        if (result.PointsLeftOut > 0)
            run.Warn(output + ": " + NumberFormat.Count(result.PointsLeftOut)
                + " points are left out, whose coordinates are no numbers or do not fit");
        // COPC's points are converted first.
        double seconds = CopcExport.IsNamed(output) ? run.Progress.Finished.Sum(stage => stage.Seconds)
            : run.Progress.Finished[^1].Seconds;
        run.WriteKeys = json =>
        {
            json.WriteInteger("points", result.Points);
            json.WriteInteger("pointsLeftOut", result.PointsLeftOut);
            json.WriteInteger("bytes", result.Bytes);
            json.WriteReal("pointsPerSecond", result.Points / seconds);
            json.WriteReal("positionError", result.PositionError);
            run.WriteLosses(json);
        };
        string moved = result.PositionError > 0
            ? ", coordinates rounded by at most " + NumberFormat.Value(result.PositionError) : "";
        run.Out.WriteLine(output + ": " + NumberFormat.Count(result.Points, "point") + ", " + NumberFormat.Bytes(result.Bytes)
            + moved + (result.Note == null ? "" : ", " + result.Note));
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }
}
