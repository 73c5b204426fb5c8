namespace FastPoints.Cli.Preview;

/// <summary>A sample to measure, in waves: each a prefix of a batch, ready after some seconds.</summary>
public sealed class MeasuredSample(PositionTransform transform) : IDisposable
{
    readonly List<(PreviewSample.Wave Wave, PointBatch Points)> m_waves = [];

    public PositionTransform Transform { get; } = transform;
    public IReadOnlyList<(PreviewSample.Wave Wave, PointBatch Points)> Waves => m_waves;
    public double Seconds => m_waves.Count == 0 ? 0 : m_waves[^1].Wave.Seconds;

    /// <param name="points">Owned by this from now on; waves may share one.</param>
    public void Add(PreviewSample.Wave wave, double secondsBefore, PointBatch points)
    {
        wave.Seconds += secondsBefore;
        m_waves.Add((wave, points));
    }

    public void Dispose()
    {
        foreach (var (_, points) in m_waves)
            points.Dispose();
    }
}
