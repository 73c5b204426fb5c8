namespace FastPoints.Cli.Cluster;

/// <summary>What a plan expects, by figures of one machine.</summary>
/// <param name="Seconds">Of all tasks together, by one core.</param>
/// <param name="TaskSeconds">Of the longest task, by one core.</param>
/// <param name="MemoryBytes">What a task keeps to.</param>
/// <param name="BytesOnDisk">Of the cloud.</param>
/// <param name="ScratchBytes">Of the largest task, on the disk where it runs.</param>
sealed record PlanEstimate(double Seconds, double TaskSeconds, long MemoryBytes, long BytesOnDisk, long ScratchBytes)
{
    /// <summary>A core of 2.1 GHz: LAS of 34 bytes a point takes 2.5 M points/s in the whole build.</summary>
    const double PointsPerSecond = 1.2e6;

    /// <summary>Finding out that a point belongs to another task.</summary>
    const double PointsSkippedPerSecond = 8e6;

    /// <summary>Stored bytes of those of plain records.</summary>
    const double StoredShare = 0.6;

    /// <summary>Records, what is made of them, and what has not been put yet.</summary>
    const double ScratchShare = 2.2;

    static readonly string s_assumptions = string.Create(CultureInfo.InvariantCulture,
        $"a core builds {PointsPerSecond / 1e6} M points/s and skips {PointsSkippedPerSecond / 1e6} M/s; stored are "
        + $"{StoredShare:p0} of plain records; a task has {ScratchShare} times its records on its disk");

    public static PlanEstimate Of(long points, int recordBytes, IEnumerable<(double Points, long Read)> tasks, long memoryBytes)
    {
        double seconds = 0, longest = 0, most = 0;
        foreach (var (built, read) in tasks)
        {
            double task = built / PointsPerSecond + Math.Max(0, read - built) / PointsSkippedPerSecond;
            seconds += task;
            longest = Math.Max(longest, task);
            most = Math.Max(most, built);
        }
        return new PlanEstimate(seconds, longest, memoryBytes, (long)(points * (double)recordBytes * StoredShare),
            (long)(most * recordBytes * ScratchShare));
    }

    public void Write(Utf8JsonWriter json)
    {
        json.WriteStartObject("estimate");
        json.WriteNumber("seconds", Math.Round(Seconds, 1));
        json.WriteNumber("memoryBytes", MemoryBytes);
        json.WriteInteger("bytesOnDisk", BytesOnDisk);
        json.WriteNumber("taskSeconds", Math.Round(TaskSeconds, 1));
        json.WriteInteger("scratchBytes", ScratchBytes);
        json.WriteString("assumes", s_assumptions);
        json.WriteEndObject();
    }

    public static PlanEstimate Read(JsonMembers json) => new(json.Number("seconds"), json.Number("taskSeconds"),
        json.Count("memoryBytes"), json.Count("bytesOnDisk"), json.Count("scratchBytes"));

    public string Describe() => NumberFormat.Duration(Seconds) + " by one core, the longest task "
        + NumberFormat.Duration(TaskSeconds) + " in " + NumberFormat.Bytes(MemoryBytes) + " and "
        + NumberFormat.Bytes(ScratchBytes)
        + " of its disk; the cloud takes " + NumberFormat.Bytes(BytesOnDisk) + " (" + s_assumptions + ")";
}
