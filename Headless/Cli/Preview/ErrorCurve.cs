namespace FastPoints.Cli.Preview;

public sealed record ErrorCurve(string Name, string Description)
{
    public List<ErrorWave> Waves { get; } = [];

    public void KeepFaster(IEnumerable<PreviewSample.Wave> rerun)
    {
        int i = 0;
        foreach (var wave in rerun)
        {
            if (wave.Seconds < Waves[i].Wave.Seconds)
                Waves[i] = Waves[i] with { Wave = wave };
            i++;
        }
    }
}

public sealed record ErrorWave(PreviewSample.Wave Wave, SampleError Error, byte[] IsoPng);
