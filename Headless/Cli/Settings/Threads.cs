using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Cli.Settings;

/// <summary>How many threads work. The main thread is one of them: it runs jobs while it waits.</summary>
public static class Threads
{
    /// <returns>A note if there are fewer cores than requested; null otherwise.</returns>
    public static string? Use(long? threads)
    {
        JobsUtility.ResetJobWorkerCount();
        if (threads is not { } count)
            return null;
        int max = Math.Min(JobsUtility.JobWorkerMaximumCount + 1, Environment.ProcessorCount);
        JobsUtility.JobWorkerCount = (int)Math.Min(count, max) - 1;
        return count <= max ? null
            : string.Create(CultureInfo.InvariantCulture, $"--threads {count}: there are {max} cores, and so many threads work");
    }

    public static int InUse => JobsUtility.JobWorkerCount + 1;
}
