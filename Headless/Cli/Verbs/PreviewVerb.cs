namespace FastPoints.Cli.Verbs;

public sealed class PreviewVerb : Verb
{
    readonly Inputs m_files = new("FILE", "Point clouds, or folders of them; several are drawn as one.");
    readonly ValueOption<string> m_output = new("--output", "P.png", "The picture.") { Aliases = { "-o" }, Required = true };
    readonly Option<long> m_points = Counts.Of("--points", "Points of the sample (default: 1,000,000).",
        new PreviewOptions().Points);
    readonly Flag m_exact = new("--exact", "Choose from a scan of all points, not from short runs of them: the reference.");
    readonly Flag m_quick = new("--quick",
        "Stop at the first N points. Of LAZ, text and several files, these are the prefixes of blocks: all of them are read "
            + "in the end without this.");
    readonly Flag m_report = new("--report",
        "Measure the error over time, of this and of other ways to sample, against all points: distances, empty cells, "
            + "evenness, pictures. Writes a page with charts, and a table. Reads the file some dozen times.");
    readonly ValueOption<string?> m_out = new("--report-output", "DIR",
        "Where --report goes (default: ./NAME-preview-report).")
    { Aliases = { "--out" } };
    readonly PictureSettings m_picture;
    readonly SourceSettings m_source;

    public PreviewVerb() : base(new Command("preview", "Draw a fair sample of a file: little is read, whatever its size."))
    {
        Command.Add(m_files, m_output, m_points, m_exact, m_quick, m_report, m_out);
        m_picture = new PictureSettings(Command, canFilter: false);
        m_source = new SourceSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints preview scan.las -o scan.png", "a million points"),
        ("./fastpoints preview scan.las -o scan.png --report", "and how far it is from the truth"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var files = parsed.GetRequiredValue(m_files);
        var options = new PreviewOptions
        {
            Points = Counts.ToInt(parsed.GetValue(m_points)),
            Exact = parsed.GetValue(m_exact),
            Quick = parsed.GetValue(m_quick),
            Picture = m_picture.Read(parsed),
        };
        string? outFolder = parsed.GetValue(m_out);
        if (outFolder != null && !parsed.GetValue(m_report))
            throw new UsageException("--report-output belongs to --report");
        string errors = outFolder ?? CloudName.Of(files[0]) + "-preview-report";
        if (parsed.GetValue(m_report))
            OutputNames.RefuseForeignFolder("a report", errors, "errors.csv", run.Settings.IsForced);
        string output = parsed.GetRequiredValue(m_output);
        OutputNames.RequirePictureName(output);
        files = run.Begin(files, output);
        var source = m_source.Read(parsed);
        using var reader = PointReaders.Open(files, source);
        run.Warn(reader.Info);
        var result = PreviewStep.Run(reader, options, run);
        run.Points.Add(reader.Info, reader.BlocksAreKnown ? reader.PointCount : reader.Info.PointsReadable);
        OutputFile.Write(output, result.ToPng(m_picture.IsPlain(parsed)));
        run.WriteKeys = json => result.WriteKeys(json);
        if (parsed.GetValue(m_report))
        {
            // Again, now that all code is compiled: the first runs included compilation.
            using (var again = PointReaders.Open(files, source))
                result.Slices = PreviewStep.Run(again, options, run).Slices;
            result.Error = ErrorStep.Run(() => PointReaders.Open(files, source), options, run);
            ErrorReport.Write(errors, result.Error, reader.Info);
        }

        run.Out.WriteLine(output + ": " + result.Describe());
        if (result.Error is { } error)
        {
            run.Out.WriteLine();
            error.ToTable().Write(run.Out, "  ");
            run.Out.WriteLine();
            run.Out.WriteLine(error.ReportPath);
            return;
        }
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }
}
