namespace FastPoints.Cli.Verbs;

public sealed class DemoCloudVerb : Verb
{
    readonly ValueOption<string> m_output = new("--output", "FILE",
        "What to write: .las or .laz (1.4, point format 7) or .ply (binary).")
    { Aliases = { "-o" }, Required = true };
    readonly Option<long> m_points = Counts.Of("--points", "Points, exactly (default: 5,000,000).", DemoCloud.DefaultPoints);
    readonly ValueOption<uint> m_seed = new("--seed", "S",
        "Another seed is another street; the same seed gives the same bytes, whatever the threads (default: 1).", 1);
    readonly ValueOption<string> m_order = new("--order", "ORDER",
        "strip: as acquired, station by station and line by line (default); tile: by tiles of 50 m; class: by class; "
            + "random: shuffled. All but strip keep the points in memory: at most 32,000,000.", "strip");
    readonly ValueOption<string?> m_tile = new("--tile", "FILE",
        "In place of a scan, repeat this LAS or LAZ file's points side by side along x, shifted by whole grid steps; to "
            + ".las, or from LAZ to .laz without decoding.");
    readonly ValueOption<int> m_times = new("--times", "N", "How often, with --tile.");

    public DemoCloudVerb() : base(
        new Command("demo-cloud", "Make a seeded terrestrial laser scan of a street (houses, trees, cars; "
        + "colour, intensity, classes, several returns; UTM-sized coordinates), or a larger file of a file."))
    {
        Command.Add(m_output, m_points, m_seed, m_order, m_tile, m_times);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints demo-cloud -o demo.las", "5 million points"),
        ("./fastpoints demo-cloud -o demo.laz --points 1000000", "compressed"),
        ("./fastpoints demo-cloud -o demo.ply --points 200000 --seed 7", "a small one, as PLY"),
        ("./fastpoints demo-cloud -o big.las --tile demo.las --times 100", "half a billion points"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string output = parsed.GetRequiredValue(m_output), file = run.Standard.FileOf(output);
        long written;
        if (parsed.GetValue(m_tile) is { } tile)
        {
            int times = parsed.GetValue(m_times);
            if (times < 1)
                throw new UsageException("--tile wants --times, at least 1");
            run.Begin([tile], output);
            written = Tile(tile, file, times, run);
        }
        else
        {
            if (parsed.GetValue(m_times) != 0)
                throw new UsageException("--times belongs to --tile");
            written = parsed.GetValue(m_points);
            if (!Enum.TryParse(parsed.GetRequiredValue(m_order), ignoreCase: true, out ScanOrder order) || !Enum.IsDefined(order))
                throw new UsageException("--order: wanted tile, strip, class or random, got " + parsed.GetValue(m_order));
            if (order != ScanOrder.Strip && written > DemoCloud.MaxOrderedPoints)
                throw new UsageException("--order " + parsed.GetValue(m_order) + " keeps the points in memory: at most "
                    + NumberFormat.Count(DemoCloud.MaxOrderedPoints));
            OutputNames.RefuseName(output);
            if (!HasExtension(file, ".las") && !HasExtension(file, ".laz") && !HasExtension(file, ".ply"))
                throw new UsageException("--output: wanted a name that ends in .las, .laz or .ply, got " + output);
            run.Begin([], output);
            DemoCloud.Write(file, written, parsed.GetValue(m_seed), order, run);
        }
        long bytes = new FileInfo(file).Length;
        run.Standard.Send(output);
        run.WriteKeys = json =>
        {
            json.WriteInteger("points", written);
            json.WriteInteger("bytes", bytes);
        };
        run.Out.WriteLine(output + ": " + NumberFormat.Count(written, "point") + ", " + NumberFormat.Bytes(bytes));
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }

    static long Tile(string tile, string output, int times, CliRun run)
    {
        bool toLaz = HasExtension(output, ".laz");
        if (!toLaz && !HasExtension(output, ".las"))
            throw new UsageException("--tile writes .las and .laz files: " + output);
        using var reader = PointReaders.Open(tile);
        bool isLas = reader.Info.Format == "LAS";
        if (toLaz && !isLas)
            return RepeatedLaz.Write(tile, output, times, run.Progress, run.Cancellation);
        if (toLaz)
            throw new UsageException("--tile makes a .laz file of a .laz file only: " + tile);
        if (isLas)
            return RepeatedLas.Write(tile, output, times, run.Progress, run.Cancellation);
        if (reader.Info.PointFormat < 0)
            throw new PointCloudException(FailureCode.Unsupported, tile, -1, "only LAS and LAZ files are tiled, this is "
                + reader.Info.Format);
        string unpacked = output + "." + Environment.ProcessId + ".las";
        try
        {
            run.RunSteps(ExportCloud.Run(reader, unpacked, new ExportSettings(), _ => { }, run.Progress));
            return RepeatedLas.Write(unpacked, output, times, run.Progress, run.Cancellation);
        }
        finally
        {
            File.Delete(unpacked);
        }
    }

    static bool HasExtension(string path, string extension) =>
        Path.GetExtension(path).Equals(extension, StringComparison.OrdinalIgnoreCase);
}
