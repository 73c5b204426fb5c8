using StandIns.Scheduling;

namespace FastPoints.Cli.Preview;

public sealed class JobDurations
{
    const int KindsNamed = 8;

    readonly Dictionary<Type, JobRuns> m_runsOfKind;

    JobDurations(Dictionary<Type, JobRuns> runsOfKind) => m_runsOfKind = runsOfKind;

    public static JobDurations Measure(Action work)
    {
        JobTimes.Begin();
        Dictionary<Type, JobRuns> taken;
        try
        {
            work();
        }
        finally
        {
            taken = JobTimes.End();
        }
        return new JobDurations(taken);
    }

    double MaxMs => m_runsOfKind.Values.Select(r => r.MaxMs).DefaultIfEmpty().Max();

    /// <summary>The time that this share of the runs does not exceed; 0 without runs.</summary>
    double QuantileMs(double share)
    {
        double wanted = share * m_runsOfKind.Values.Sum(r => (long)r.Count);
        long sum = 0;
        for (int bucket = 0; sum < wanted; bucket++)
        {
            sum += m_runsOfKind.Values.Sum(r => (long)r.RunsOfBucket[bucket]);
            if (sum >= wanted)
                return Math.Min(MaxMs, (bucket + 1) * JobRuns.MsPerBucket);
        }
        return 0;
    }

    public void WriteKey(Utf8JsonWriter json)
    {
        json.WriteStartObject("sliceMs");
        json.WriteReal("p50", QuantileMs(0.5));
        json.WriteReal("p99", QuantileMs(0.99));
        json.WriteReal("max", MaxMs);
        json.WriteStartObject("longest");
        foreach (var (kind, runs) in m_runsOfKind.OrderByDescending(k => k.Value.MaxMs).Take(KindsNamed))
            json.WriteReal(kind.Name, runs.MaxMs);
        json.WriteEndObject();
        json.WriteEndObject();
    }
}
