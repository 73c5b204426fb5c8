using StandIns.Io;

namespace FastPoints.Cli.Verbs;

/// <summary>Streams converted clouds along a camera path, as a player would.</summary>
public sealed class FlyVerb : Verb
{
    const double FrameSeconds = 1 / 60.0;
    const int DefaultFrames = 600;
    const int MaxFramesPerPicture = 3600; // An animation shows a picture for a minute at most: 65,535 ms.

    readonly Inputs m_clouds = new("CLOUD",
        "Converted clouds, COPC, Potree or EPT as they are, previews of other files; all are flown over at once, where "
            + "their coordinates put them.");
    readonly ValueOption<string?> m_path = new("--path", "FILE",
        "The camera's way, a line each: frame eyeX eyeY eyeZ targetX targetY targetZ [cut] (default: an overview, a dive, a "
            + "way along the ground, a cut).");
    readonly Option<long?> m_frames = Counts.Optional("--frames",
        "Frames, 60 a second (default: 600, or as many as the path has).");
    readonly Flag m_cpu = new("--cpu", "Draw in software (default).");
    readonly Flag m_gpu = new("--gpu", "Upload to a graphics card and draw there, by Vulkan; Mesa's lavapipe will do.");
    readonly ValueOption<string?> m_output = new("--output", "DIR|NAME.webp|NAME.png|NAME%04d.png",
        "Draw: an animation, or single pictures; a folder gets the smaller animation, last.png, frames.csv and report.html "
            + "(the camera's way in 3D, and charts of each frame). Without it nothing is drawn. WebP takes the system's "
            + "libwebp.")
    { Aliases = { "-o" } };
    readonly Option<long> m_every = Counts.Of("--every", "Draw every Nth frame (default: 6, ten pictures a second).", 6);
    readonly Option<long> m_budget = Counts.Of("--budget", "Points of all clouds at once (default: 2,000,000).", 2_000_000);
    readonly Option<long> m_pool = Counts.Of("--pool",
        "Memory of what is resident (default: 256 MiB). A hard limit.", 256, "MIB");
    readonly Option<long> m_upload = Counts.Of("--upload",
        "Copied into it in one frame at most (default: 4096 KiB).", 4096, "KIB");
    readonly ValueOption<double> m_fade = new("--fade", "SECONDS",
        "How long a node takes to appear or to leave, point by point (default: 0.25; 0: at once).",
        StreamSettings.SceneFadeSeconds);
    readonly Flag m_popping = new("--popping",
        "Measure popping, in software: each frame's picture against what the frame before drew, seen from the same camera, "
            + "as FLIP. Frames then take longer, so that reads have more time.");
    readonly Option<long> m_pointsPerFrame = Counts.Of("--points-per-frame",
        "With --gpu: pictures of more points take several, each with the visible points; --every 1 for as in a game.", 0);
    readonly PictureSettings m_picture;

    public FlyVerb() : base(new Command("fly", "Stream clouds along a camera path, 60 frames a second: what each frame "
        + "selected, read, copied and drew, and how long it took."))
    {
        Command.Add(m_clouds, m_path, m_frames, m_cpu, m_gpu, m_output, m_every, m_budget, m_pool, m_upload, m_fade, m_popping,
            m_pointsPerFrame);
        m_picture = new PictureSettings(Command, canFilter: true);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints fly scan.fastpoints -o flight", "look at it"),
        ("./fastpoints fly scan.fastpoints -o flight.webp", "an animation to send"),
        ("./fastpoints fly a.fastpoints b.copc.laz --frames 1200", "figures only"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var clouds = parsed.GetRequiredValue(m_clouds);
        string? output = parsed.GetValue(m_output);
        run.Begin(clouds);
        if (output != null)
        {
            OutputNames.RefuseInputs(output, clouds);
            if (!FlightOutput.IsFile(output))
                OutputNames.RefuseForeignFolder("a flight", output, "frames.csv", run.Settings.IsForced);
            else
                OutputNames.RefuseForeign(FlightOutput.NameOf(output, 0), run.Settings.IsForced);
        }
        var options = m_picture.Read(parsed);
        int every = Counts.ToInt(parsed.GetValue(m_every)), requested = Counts.ToInt(parsed.GetValue(m_frames) ?? 0);
        if (every > MaxFramesPerPicture)
            throw new UsageException("--every: wanted 1 to " + MaxFramesPerPicture);
        if (parsed.GetValue(m_cpu) && parsed.GetValue(m_gpu))
            throw new UsageException("--cpu or --gpu, not both");
        if (parsed.GetValue(m_popping) && parsed.GetValue(m_gpu))
            throw new UsageException("--popping or --gpu, not both");
        string? folder = output == null || FlightOutput.IsFile(output) ? null : output;
        if (folder != null)
            OutputFile.MakeFolder(folder);

        long pool = Math.Min(parsed.GetValue(m_pool), 1 << 30) << 20;
        int bank = (int)Math.Min(16 << 20, pool / 4), upload = (int)Math.Min(1 << 20, parsed.GetValue(m_upload)) << 10;
        var shaders = parsed.GetValue(m_gpu) ? new GpuShaders() : null;
        using var stream = new StreamContext(shaders?.CreatePool(pool, bank) ?? new MemoryNodePool(pool, bank));
        stream.Settings.Selection.PointBudget = parsed.GetValue(m_budget);
        stream.Settings.MaxUploadBytesPerFrame = upload;
        stream.Settings.FadeSeconds = (float)parsed.GetValue(m_fade);
        stream.FrameSeconds = (float)FrameSeconds;
        stream.SetClipBoxes(options.ClipBoxes);
        using var picture = shaders != null
            ? new GpuFlightRenderer(shaders, stream, options)
            {
                PointsPerFrame = Counts.ToInt(parsed.GetValue(m_pointsPerFrame)),
            }
            : (FlightRenderer)new CpuFlightRenderer(stream, options) { MeasuresPopping = parsed.GetValue(m_popping) };
        var bounds = AddClouds(clouds, stream, picture, run.Cancellation);
        options.UpAxis.Directions(out _, out _, out var up);
        var path = parsed.GetValue(m_path) is { } file ? CameraPath.Read(file, up, options.FovDegrees)
            : CameraPath.Tour(bounds, options.UpAxis, requested > 0 ? requested : DefaultFrames, options.FovDegrees);
        int frames = requested > 0 ? requested : path.FrameCount;

        var log = new FlightLog(frames);
        double disposeMs = 0;
        // The end of each part is drawn: at its beginning nothing is loaded yet.
        every = Math.Min(every, frames);
        using var pictures = output == null ? null
            : new FlightOutput(output, options, frames / every, (int)(every * FrameSeconds * 1000), AnimatedWebp.CanWrite)
            {
                Every = every,
            };
        run.WriteKeys = json => WriteKeys(json, log, pictures, disposeMs);
        var last = Fly(stream, path, picture, pictures, log, run);
        pictures?.Commit();
        if (folder != null)
            OutputFile.Write(Path.Combine(folder, "frames.csv"), System.Text.Encoding.UTF8.GetBytes(log.ToCsv()));
        long end = Stopwatch.GetTimestamp();
        stream.Dispose();
        disposeMs = Stopwatch.GetElapsedTime(end).TotalMilliseconds;
        if (folder != null && last != null)
        {
            OutputFile.Write(Path.Combine(folder, "last.png"), Png.Encode(last));
            OutputFile.Write(Path.Combine(folder, "report.html"), FlightPage.Make(clouds, path, log, options, last, run));
        }
        if (pictures?.CommittedPath is { } kept)
            run.Out.WriteLine(kept + ": " + NumberFormat.Count(frames / every) + " pictures, "
                + NumberFormat.Bytes(pictures.Bytes));
        run.WarnOfFailures(stream);
        Describe(run, log, stream.Settings.MaxUploadBytesPerFrame, disposeMs);
    }

    static BoundsGeo AddClouds(string[] clouds, StreamContext stream, FlightRenderer picture, CancellationToken cancellation)
    {
        var bounds = BoundsGeo.Empty;
        foreach (string cloud in clouds)
        {
            var (plan, ranges, number) = FlightCloud.Add(cloud, stream, picture.Options, cancellation,
                SourcePath.IsRemote(cloud));
            picture.Add(number, plan);
            if (!ranges.Robust.IsEmpty)
                bounds = bounds.IsEmpty ? ranges.Robust
                    : new BoundsGeo(math.min(bounds.Min, ranges.Robust.Min), math.max(bounds.Max, ranges.Robust.Max));
        }
        return !bounds.IsEmpty ? bounds
            : throw new PointCloudException(FailureCode.BadInput, clouds[0], -1, "no points to fly over");
    }

    static RgbaImage? Fly(StreamContext stream, CameraPath path, FlightRenderer picture, FlightOutput? pictures,
        FlightLog log, CliRun run)
    {
        int frames = log.Frames;
        run.Progress.Begin("fly");
        using var views = new NativeArray<StreamView>(2, Allocator.Persistent);
        RgbaImage? last = null;
        IoThreads.Prepare(2 * stream.Files.MaxOpenFiles);
        double begin = log.BeginSeconds = run.Seconds;
        for (int frame = 0; frame < frames; frame++)
        {
            run.Cancellation.ThrowIfCancellationRequested();
            var camera = path.CameraAt(frame);
            var view = picture.Plan!.ViewsFor(stream, camera, views);
            long garbage = GC.GetAllocatedBytesForCurrentThread(), start = Stopwatch.GetTimestamp();
            var stats = FrameStep.Run(stream, view);
            double mainThreadMs = Stopwatch.GetElapsedTime(start).TotalMilliseconds;
            garbage = GC.GetAllocatedBytesForCurrentThread() - garbage;
            JobHandle.ScheduleBatchedJobs();
            bool isShown = pictures != null && (frame + 1) % pictures.Every == 0, isCut = frame == 0 || path.IsCut(frame);
            double popping = double.NaN;
            if (isShown || picture.MeasuresPopping || (pictures != null && frame == frames - 1))
                last = picture.Draw(camera);
            if (isShown)
                pictures!.Add(last!);
            if (picture.MeasuresPopping)
                popping = picture.MeasurePopping(camera, last!, isCut);
            picture.EndFrame();
            // A frame at 60 Hz: without anything to draw, it waits for the screen.
            double rest = FrameSeconds - Stopwatch.GetElapsedTime(start).TotalSeconds;
            if (rest > 0)
                Thread.Sleep(TimeSpan.FromSeconds(rest));
            log.Add(new FlightFrame
            {
                Stats = stats,
                MainThreadMs = mainThreadMs,
                FrameMs = Stopwatch.GetElapsedTime(start).TotalMilliseconds,
                GarbageBytes = garbage,
                AtSeconds = run.Seconds - begin,
                IsCut = isCut,
                Popping = popping,
            });
            run.Progress.Report((frame + 1.0) / frames, stats.DrawnPoints, 0);
        }
        run.Progress.End();
        return last;
    }

    static void Describe(CliRun run, FlightLog log, int uploadBytes, double disposeMs)
    {
        static string Ms(double value) => value.ToString("0.00", CultureInfo.InvariantCulture);
        run.Out.WriteLine("last frame: " + NumberFormat.Count(log.Last.DrawnPoints, "point") + " of "
            + NumberFormat.Count(log.Last.DrawnNodes, "node") + ", "
            + NumberFormat.Bytes(log.PoolBytesPeak) + " of pool at most, " + NumberFormat.Bytes(log.BytesRead) + " read");
        var main = log.MainThreadMs;
        run.Out.WriteLine($"main thread: {Ms(main[0])} ms, p99 {Ms(main[1])}, most {Ms(log.MaxLaterMs)} after the first frame, "
            + $"which took {Ms(log.FirstMs)} (selection p99 {Ms(log.SelectMs[1])}, requests p99 {Ms(log.RequestMs[1])}); "
            + $"{log.Hitches} hitches; {NumberFormat.Bytes(log.GarbageBytes)} of garbage, "
            + $"{NumberFormat.Bytes(log.GarbageBytesAfterWarmUp)} of it after 60 frames");
        foreach (var (frame, toFull, bytes) in log.Cuts())
            run.Out.WriteLine($"from frame {frame}: "
                + (toFull < 0 ? "never 95 % drawn" : $"95 % drawn after {toFull} frames; "
                + $"its {NumberFormat.Bytes(bytes)} need {(bytes + uploadBytes - 1) / uploadBytes}"));
        if (run.Inputs.Any(SourcePath.IsRemote))
            run.Out.WriteLine("95 % drawn "
                + (double.IsNaN(log.SecondsTo95) ? "never" : Ms(log.SecondsTo95) + " s after the start")
                + "; " + NumberFormat.Count(RemoteStatistics.Requests, "request") + " for "
                + NumberFormat.Bytes(RemoteStatistics.BytesFetched)
                + ", " + NumberFormat.Bytes(RemoteStatistics.BytesUnused) + " of it unused; "
                + NumberFormat.Count(RemoteStatistics.CacheHits, "range") + " from this machine's cache");
        run.Out.WriteLine($"ended in {Ms(disposeMs)} ms");
        if (log.Popping is { } popping)
            run.Out.WriteLine("popping: " + popping + (log.PoppingWhenLoaded is { } loaded ? "; once loaded, " + loaded : ""));
        foreach (string warning in run.Warnings)
            run.Out.WriteLine("  " + warning);
    }

    static void WriteKeys(Utf8JsonWriter json, FlightLog log, FlightOutput? pictures, double disposeMs)
    {
        void Write(string name, double[] values)
        {
            json.WriteStartObject(name);
            json.WriteReal("p50", values[0]);
            json.WriteReal("p99", values[1]);
            json.WriteReal("max", values[2]);
            json.WriteEndObject();
        }
        json.WriteInteger("frames", log.Count);
        if (log.Count == 0)
            return;
        Write("frameMs", log.FrameMs);
        Write("mainThreadMs", log.MainThreadMs);
        json.WriteReal("firstFrameMs", log.FirstMs);
        json.WriteReal("mostLaterMs", log.MaxLaterMs);
        Write("selectMs", log.SelectMs);
        Write("requestMs", log.RequestMs);
        json.WriteInteger("hitches", log.Hitches);
        json.WriteInteger("garbageBytes", log.GarbageBytes);
        json.WriteInteger("garbageBytesAfter60Frames", log.GarbageBytesAfterWarmUp);
        json.WriteInteger("pointsDrawn", log.Last.DrawnPoints);
        json.WriteInteger("nodesDrawn", log.Last.DrawnNodes);
        json.WriteInteger("bytesRead", log.BytesRead);
        json.WriteInteger("poolBytesPeak", log.PoolBytesPeak);
        json.WriteReal("secondsToFull", log.SecondsToFull);
        json.WriteReal("secondsTo95", log.SecondsTo95);
        json.WriteObjects("cuts", log.Cuts(), cut =>
        {
            json.WriteInteger("frame", cut.Frame);
            json.WriteInteger("framesToFull", cut.FramesToFull);
            json.WriteInteger("bytes", cut.Bytes);
        });
        json.WriteReal("disposeMs", disposeMs);
        log.Popping?.WriteKey(json, "popping");
        log.PoppingWhenLoaded?.WriteKey(json, "poppingWhenLoaded");
        if (pictures?.CommittedPath is not { } kept)
            return;
        json.WriteString("animation", kept);
        json.WriteInteger("bytes", pictures.Bytes);
    }
}
