namespace FastPoints.Cli.Verbs;

public sealed class PictureVerb : Verb
{
    readonly Inputs m_clouds = new("CLOUD",
        "A converted cloud; or point clouds, or folders of them: several are drawn as one. With --budget, COPC, Potree and "
            + "EPT are drawn from their own octrees; so are converted clouds and these together.");
    readonly ValueOption<string> m_output = new("--output", "P.png", "The picture.") { Aliases = { "-o" }, Required = true };
    readonly Option<long?> m_budget = Counts.Optional("--budget",
        "Draw at most so many points (default: every one of a file, 2,000,000 of a converted cloud).");
    readonly ValueOption<string?> m_against = new("--against", "Q.png",
        "Another picture of the same size: say how far the new one is from it (PSNR, SSIM, FLIP, uncovered pixels).");
    readonly ValueOption<string?> m_flipMap = new("--flip-map", "F.png",
        "With --against: a picture of where an eye sees the difference, by FLIP (67 pixels per degree); black for none, "
            + "light for the largest.");
    readonly Option<long> m_samples = Counts.Of("--samples",
        "Draw so many samples along each edge of a pixel and average their light (default: 1, at most 4): with 4, smooth, "
        + "to compare others --against.", 1);
    readonly Flag m_gpu = new("--gpu",
        "Stream a converted cloud to a graphics card and draw it there, by Vulkan; Mesa's lavapipe will do.");
    readonly PictureSettings m_picture;
    readonly SourceSettings m_source;

    public PictureVerb() : base(new Command("picture", "Draw every point of a cloud with a camera of one's choice."))
    {
        Command.Add(m_clouds, m_output);
        m_picture = new PictureSettings(Command, canFilter: true);
        Command.Add(m_budget, m_against, m_flipMap, m_samples, m_gpu);
        m_source = new SourceSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints picture scan.las -o top.png --view top", "a map"),
        ("./fastpoints picture scan.fastpoints -o p.png --budget 1000000", "from the octree"),
        ("./fastpoints picture scan.fastpoints -o p.png --gpu", "by the renderer that a game would use"),
        ("./fastpoints picture scan.las -o c.png --style color=classification", "by class"),
        ("./fastpoints picture scan.fastpoints -o g.png --style classes=2,size=adaptive",
            "the ground alone, its surface closed"),
        ("./fastpoints picture scan.las -o p.png --eye 0,-50,20 --target 0,0,0", "a camera of one's own"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var clouds = parsed.GetRequiredValue(m_clouds);
        string output = parsed.GetRequiredValue(m_output);
        string? against = parsed.GetValue(m_against), flipMap = parsed.GetValue(m_flipMap);
        var options = m_picture.Read(parsed);
        options.SamplesPerEdge = Counts.ToInt(parsed.GetValue(m_samples));
        if (options.SamplesPerEdge > PictureCanvas.MaxSamplesPerEdge)
            throw new UsageException("--samples: wanted 1 to " + PictureCanvas.MaxSamplesPerEdge);
        if (options.SamplesPerEdge > 1 && parsed.GetValue(m_gpu))
            throw new UsageException("--samples or --gpu, not both");
        long budget = parsed.GetValue(m_budget) ?? 0;
        OutputNames.RequirePictureName(output);
        if (flipMap != null)
            RequireFlipMapName(flipMap, output, against);
        clouds = run.Begin(against != null ? clouds.Append(against) : clouds, Outputs(output, flipMap))[..clouds.Length];
        var reference = against != null ? Png.Read(against) : null;
        if (reference != null && (reference.Width != options.WidthPx || reference.Height != options.HeightPx))
            throw PointCloudException.Wanted(FailureCode.BadInput, against, -1, "size",
                options.WidthPx + "x" + options.HeightPx, reference.Width + "x" + reference.Height);

        // Drawn as in a game, on the CPU or the GPU.
        if (clouds.Any(CloudFolder.IsCloud))
            FlightCloud.SetSize(options, clouds);
        var result = parsed.GetValue(m_gpu) ? DrawStep.RunOnGpu(clouds, options, budget, run)
            : clouds.Length == 1 && CloudFolder.IsCloud(clouds[0]) && !IsForStream(options)
            ? DrawStep.RunConverted(clouds[0], options, budget, run)
            : clouds.Any(CloudFolder.IsCloud)
                || (budget > 0 && options.ColorAttribute == null || options.IsFiltered) && clouds.All(HasOctree)
            ? StreamedPictureStep.Run(clouds, options, budget, run)
            : options.IsFiltered
            ? throw new UsageException("--clip, --cut and classes want clouds that are converted, or bring octrees along")
            : Draw(clouds, m_source.Read(parsed), options, budget, run);
        if (!MemoryMarshal.Cast<byte, uint>(result.Image.Rgba).ContainsAnyExcept(options.Background))
            WarnEmpty(output, clouds, m_source.Read(parsed), options, run);
        var image = result.ToImage(m_picture.IsPlain(parsed));
        if (reference != null)
            result.Compare(image, reference, options.Background);
        run.WriteKeys = result.WriteKeys;
        OutputFile.Write(output, Png.Encode(image));
        if (flipMap != null)
            OutputFile.Write(flipMap, Png.Encode(FlipMap.Of(image, reference!).ToImage()));

        run.Out.WriteLine(output + ": " + result.Describe());
        foreach (string assumption in result.Assumptions)
            run.Out.WriteLine("  " + assumption);
        if (result.DescribeDifference() is { } error)
            run.Out.WriteLine("  against " + against + ": " + error);
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }

    static void RequireFlipMapName(string flipMap, string output, string? against)
    {
        if (against == null)
            throw new UsageException("--flip-map wants --against");
        OutputNames.RequirePictureName(flipMap, "--flip-map");
        OutputNames.RefuseSame("--flip-map", flipMap, output);
    }

    static string[] Outputs(string output, string? flipMap) => flipMap != null ? [output, flipMap] : [output];

    static bool IsForStream(PictureOptions options) => options.SizeInWorld?.Mode == PointSizeMode.Adaptive || options.IsFiltered;

    static void WarnEmpty(string output, string[] clouds, ReadOptions source, PictureOptions options, CliRun run)
    {
        long points = 0;
        var bounds = BoundsGeo.Empty;
        foreach (string cloud in clouds)
        {
            using PointReader reader = CloudFolder.IsCloud(cloud) ? ConvertedReader.Open(cloud)
                : PointReaders.Open(cloud, source);
            points += Math.Max(0, reader.Info.PointsReadable); // Less than 0: unknown.
            bounds.Include(reader.Info.BoundsIfFinite);
        }
        run.WarnEmpty(output, "to be seen", points, bounds, options.ClipBoxes);
    }

    static bool HasOctree(string path)
    {
        using var reader = PointReaders.Open(path);
        return reader.Tree != null;
    }

    static DrawStep Draw(string[] files, ReadOptions source, PictureOptions options, long budget, CliRun run)
    {
        using var reader = PointReaders.Open(files, source);
        run.Warn(reader.Info);
        var drawn = DrawStep.Run(reader, options, budget, run);
        run.Points.Add(reader.Info, reader.BlocksAreKnown ? reader.PointCount : reader.Info.PointsReadable);
        return drawn;
    }
}
