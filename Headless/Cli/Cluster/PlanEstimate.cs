namespace FastPoints.Cli.Cluster;

/// <summary>What a plan expects, by figures of one machine.</summary>
/// <param name="Seconds">Of all tasks together, by one core.</param>
/// <param name="TaskSeconds">Of the longest task, by one core.</param>
/// <param name="MemoryBytes">What a task keeps to.</param>
/// <param name="BytesOnDisk">Of the cloud.</param>
/// <param name="ScratchBytes">Of the largest build, on the disk where it runs.</param>
sealed record PlanEstimate(double Seconds, double TaskSeconds, long MemoryBytes, long BytesOnDisk, long ScratchBytes)
{
    const double PointsPerSecond = 1.5e6; // 24 M points of LAZ by eight tasks in 15 s of processor time, of LAS in 10.

    /// <summary>Finding out that a point belongs to another task: of LAZ in 0.29 us, of LAS in far less.</summary>
    const double PointsSkippedPerSecond = 3.5e6;
    const double PointsSortedPerSecond = 2.2e6; // Into buckets: of LAZ, of LAS 6 M.

    const double StoredBytesPerRecordByte = 0.35;
    const double ScratchBytesPerRecordByte = 2.2; // Records, what is made of them, and what has not been put yet.

    static readonly string s_assumptions = string.Create(CultureInfo.InvariantCulture,
        $"a core builds {PointsPerSecond / 1e6} M points/s skips {PointsSkippedPerSecond / 1e6} M/s, and sorts"
        + $" {PointsSortedPerSecond / 1e6} M/s into buckets; stored are "
        + $"{StoredBytesPerRecordByte:p0} of plain records; "
        + $"a task has {ScratchBytesPerRecordByte} times its records on its disk");

    public static PlanEstimate Of(long points, int recordBytes, IEnumerable<IEnumerable<(double Points, long Read)>> tasks,
        long memoryBytes, bool isBucketed)
    {
        double seconds = isBucketed ? points / PointsSortedPerSecond : 0, longest = 0, most = 0;
        foreach (var builds in tasks)
        {
            double task = 0;
            foreach (var (built, read) in builds)
            {
                task += built / PointsPerSecond + Math.Max(0, read - built) / PointsSkippedPerSecond;
                most = Math.Max(most, built);
            }
            seconds += task;
            longest = Math.Max(longest, task);
        }
        return new PlanEstimate(seconds, longest, memoryBytes, (long)(points * (double)recordBytes * StoredBytesPerRecordByte),
            (long)(most * recordBytes * ScratchBytesPerRecordByte));
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
        json.NonNegative("memoryBytes"), json.NonNegative("bytesOnDisk"), json.NonNegative("scratchBytes"));

    public string Describe() => NumberFormat.Duration(Seconds) + " by one core, the longest task "
        + NumberFormat.Duration(TaskSeconds) + " in " + NumberFormat.Bytes(MemoryBytes) + " and "
        + NumberFormat.Bytes(ScratchBytes)
        + " of its disk; the cloud takes " + NumberFormat.Bytes(BytesOnDisk) + " (" + s_assumptions + ")";
}
