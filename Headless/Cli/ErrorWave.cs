using FastPoints.Evaluation;
using FastPoints.Preview;

namespace FastPoints.Cli
{
    /// <summary>One point of a curve of error over time.</summary>
    public sealed record ErrorWave(SampleWave Wave, SampleError Error, byte[] IsoPng);
}
