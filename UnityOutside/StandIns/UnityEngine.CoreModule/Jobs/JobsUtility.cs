namespace Unity.Jobs.LowLevel.Unsafe;

public static partial class JobsUtility
{
    public const int MaxJobThreadCount = 128;
    public const int CacheLineSize = 64;

    /// <summary>Worker threads, besides the main thread, which helps while it waits.</summary>
    public static int JobWorkerCount
    {
        get => JobWorkers.Count;
        set => JobWorkers.Count = value;
    }

    public static int JobWorkerMaximumCount => JobWorkers.MaximumCount;
    public static int ThreadIndex => JobThread.Index;
    public static int ThreadIndexCount => JobWorkers.MaximumCount + 1;

    public static void ResetJobWorkerCount() => JobWorkers.Count = JobWorkers.DefaultCount;
}
