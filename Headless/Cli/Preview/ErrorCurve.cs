namespace FastPoints.Cli.Preview;

/// <summary>How the error of one way of sampling goes down with time.</summary>
public sealed record ErrorCurve(string Name, string What)
{
    public List<ErrorWave> Waves { get; } = [];

    /// <summary>The same waves taken once more: the sooner one of each counts.</summary>
    public void TakeSooner(IEnumerable<SampleWave> again)
    {
        int i = 0;
        foreach (var wave in again)
        {
            if (wave.Seconds < Waves[i].Wave.Seconds)
                Waves[i] = Waves[i] with { Wave = wave };
            i++;
        }
    }
}

/// <summary>One point of a curve of error over time.</summary>
public sealed record ErrorWave(SampleWave Wave, SampleError Error, byte[] IsoPng);
