using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Cli.Settings;

/// <summary>How many threads work. The main thread is one of them: it runs jobs while it waits.</summary>
public static class Threads
{
    public static void Use(int? threads)
    {
        if (threads is not { } count)
        {
            JobsUtility.ResetJobWorkerCount();
            return;
        }
        int most = JobsUtility.JobWorkerMaximumCount + 1;
        if (count < 1 || count > most)
            throw new UsageException(string.Create(CultureInfo.InvariantCulture, $"--threads {count}: wanted 1 to {most}"));
        JobsUtility.JobWorkerCount = count - 1;
    }

    public static int InUse => JobsUtility.JobWorkerCount + 1;
}
