namespace FastPoints.Cli.Page;

/// <summary>How far the waves of a sample are from the cloud: RMS distance of a uniform choice of its points to the nearest one
/// of the wave, in units of its coordinates.</summary>
static class WaveErrors
{
    const int Queries = 100_000;
    const uint Seed = 0x9E3779B9; // Not the samplers' own, so that no sample is measured by itself.

    public static List<double> Measure(PointReader reader, MeasuredSample taken, CliRun run)
    {
        if (!reader.BlocksAreKnown)
            run.RunSteps(reader.IndexBlocks());
        run.Progress.Begin("error of the waves");
        using var uniform = new FileOrderSampler(reader, Queries, Seed);
        run.RunSteps(uniform.Run(0, run.Progress));
        using var sample = uniform.TakeSample();
        using var queries = new NativeArray<double3>(Math.Max(1, sample.Count), Allocator.Persistent);
        using var loaded = new NativeReference<int>(Allocator.Persistent);
        new LoadPositionsJob
        {
            Bytes = sample.Points.Bytes,
            Positions = PositionColumns.Of(sample.Points),
            Transform = sample.Transform,
            Count = sample.Count,
            Points = queries,
            Loaded = loaded,
        }.Schedule().Complete();
        var errors = taken.Waves.Select(w =>
            Measure(w.Points, w.Wave.Points, taken.Transform, queries, loaded.Value, run)).ToList();
        run.Progress.End();
        return errors;
    }

    static double Measure(PointBatch points, int count, PositionTransform transform, NativeArray<double3> queries,
        int queryCount, CliRun run)
    {
        using var tree = new PointTree();
        run.RunSteps(tree.Build(points, count, transform));
        double rms = double.NaN;
        run.RunSteps(tree.Measure(queries, queryCount, 1, found => rms = found.Rms));
        return rms;
    }
}
