namespace StandIns.Scheduling;

/// <summary>What a thread is to the job system.</summary>
static class JobThread
{
    [ThreadStatic] static int t_index;
    [ThreadStatic] static bool t_isWorker;
    [ThreadStatic] static int t_executing;
    internal static int Index => t_index; // 0 on the main thread, workers from 1.

    internal static bool IsWorker => t_isWorker;
    internal static bool IsExecuting => t_executing != 0;

    internal static void BecomeWorker(int index)
    {
        t_index = index;
        t_isWorker = true;
    }

    internal static void Enter() => t_executing++;
    internal static void Leave() => t_executing--;
}
