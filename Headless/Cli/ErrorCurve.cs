using System.Collections.Generic;

namespace FastPoints.Cli
{
    /// <summary>How the error of one way of sampling goes down with time.</summary>
    public sealed record ErrorCurve(string Name, string What)
    {
        public List<ErrorWave> Waves { get; } = [];
    }
}
