namespace StandIns.Scheduling;

sealed class JobRuns
{
    internal const double MsPerBucket = 0.01;

    readonly int[] m_runsOfBucket = new int[4096];

    internal ReadOnlySpan<int> RunsOfBucket => m_runsOfBucket;
    internal int Count { get; private set; }
    internal double MaxMs { get; private set; }

    internal void Add(double ms)
    {
        Count++;
        MaxMs = Math.Max(MaxMs, ms);
        m_runsOfBucket[(int)Math.Min(ms / MsPerBucket, m_runsOfBucket.Length - 1)]++;
    }
}
