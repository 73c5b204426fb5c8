namespace FastPoints.Cli.Preview;

public sealed class SampleMethods(Func<PointReader> open, PreviewOptions options, CliRun run)
{
    public int Runs { get; init; } = 3;
    const double QuickSeconds = 3;
    const int MaxSinglePoints = 20_000;

    public MeasuredSample Ours() => Timed((reader, secondsToOpen) =>
    {
        var measured = new MeasuredSample(reader.Info.Transform);
        bool refines = PreviewSampling.Refines(reader);
        int wanted = refines ? RefiningSampler.FirstSamplePoints(reader, options.Points) : options.Points;
        var watch = Stopwatch.StartNew();
        using var sampler = new PreviewWaveSampler(reader, wanted, options.Seed);
        var waves = new List<PreviewSample.Wave>();
        sampler.WaveReady += waves.Add;
        run.RunSteps(sampler.Run(0, run.Progress));
        var sample = sampler.TakeSample();
        foreach (var wave in waves)
            measured.Add(wave, secondsToOpen, sample.Points);
        if (!refines || sample.HasAllPoints)
            return measured;
        var ranges = new DisplayRanges();
        run.RunSteps(ranges.Measure(sample.Points, sample.Transform, options.Picture.UpAxis));
        using var refining = new RefiningSampler(reader, options.Points, options.Seed, sample, ranges.Robust);
        double secondsBefore = secondsToOpen + watch.Elapsed.TotalSeconds;
        refining.WaveReady += wave => measured.Add(wave, secondsBefore, refining.TakeSample().Points);
        run.RunSteps(refining.Run(0, run.Progress));
        return measured;
    });

    public MeasuredSample FullScan(int points) => Timed((reader, secondsToOpen) =>
    {
        var watch = Stopwatch.StartNew();
        using var sampler = new FileOrderSampler(reader, points, options.Seed);
        run.RunSteps(sampler.Run(0, run.Progress));
        double seconds = secondsToOpen + watch.Elapsed.TotalSeconds;
        var sample = sampler.TakeSample();
        return OneWave(sample.Points, reader, seconds, sample.BytesRead);
    });

    public MeasuredSample EveryNth(int points) => Timed((reader, secondsToOpen) => Ranges(reader, secondsToOpen,
        reader.HasCheapRanges && points <= MaxSinglePoints && points <= reader.PointCount
            ? RangeSampler.Single(reader, points)
            : RangeSampler.Whole(reader), points));

    public MeasuredSample First(int points) =>
        Timed((reader, secondsToOpen) => Ranges(reader, secondsToOpen, RangeSampler.First(reader, points), points));

    public MeasuredSample Prefixes(double share, int points) =>
        Timed((reader, secondsToOpen) => Ranges(reader, secondsToOpen, RangeSampler.Prefixes(reader, share), points));

    public MeasuredSample ThinnedPrefixes(int points, int times) => Timed((reader, secondsToOpen) =>
    {
        var watch = Stopwatch.StartNew();
        var ranges = RangeSampler.Prefixes(reader, Math.Min(1, (double)times * points / reader.PointCount));
        using var sampler = new RangeSampler(reader, ranges, int.MaxValue);
        run.RunSteps(sampler.Run(run.Progress));
        using var decoded = sampler.TakePoints();
        var display = new DisplayRanges();
        run.RunSteps(display.Measure(decoded, reader.Info.Transform, options.Picture.UpAxis));
        var thinned = CellThinning.Thin(decoded, reader.Info.Transform, display, points);
        return OneWave(thinned, reader, secondsToOpen + watch.Elapsed.TotalSeconds, sampler.BytesRead);
    });

    MeasuredSample Ranges(PointReader reader, double secondsToOpen, List<BlockRange> ranges, int points)
    {
        var watch = Stopwatch.StartNew();
        using var sampler = new RangeSampler(reader, ranges, points);
        run.RunSteps(sampler.Run(run.Progress));
        return OneWave(sampler.TakePoints(), reader, secondsToOpen + watch.Elapsed.TotalSeconds, sampler.BytesRead);
    }

    static MeasuredSample OneWave(PointBatch points, PointReader reader, double seconds, long bytesRead)
    {
        var measured = new MeasuredSample(reader.Info.Transform);
        measured.Add(new PreviewSample.Wave { Points = points.Count, BytesRead = bytesRead }, seconds, points);
        return measured;
    }

    /// <param name="take">From an open reader whose blocks are known, and the seconds that this took.</param>
    MeasuredSample Timed(Func<PointReader, double, MeasuredSample> take)
    {
        MeasuredSample? best = null;
        for (int i = 0; i < Runs; i++)
        {
            // Garbage of earlier samples must not be collected within this one's time.
            GC.Collect();
            var watch = Stopwatch.StartNew();
            using var reader = open();
            if (!reader.BlocksAreKnown)
                run.RunSteps(reader.IndexBlocks());
            var measured = take(reader, watch.Elapsed.TotalSeconds);
            if (best == null || measured.Seconds < best.Seconds)
            {
                best?.Dispose();
                best = measured;
            }
            else
            {
                measured.Dispose();
            }
            if (best.Seconds > QuickSeconds)
                break;
        }
        return best!;
    }
}
