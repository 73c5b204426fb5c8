namespace StandIns;

/// <summary>The main thread: the first that used what belongs to it, or, that one being gone, the next. Workers and threads of
/// the pool never are.</summary>
static class MainThread
{
    static Thread s_main;

    /// <summary>Whether the calling thread is it.</summary>
    internal static bool IsCurrent
    {
        get
        {
            Thread current = Thread.CurrentThread;
            Thread main = s_main;
            if (main == current)
                return true;
            if (JobThread.IsWorker || current.IsThreadPoolThread || (main != null && main.IsAlive))
                return false;
            return Interlocked.CompareExchange(ref s_main, current, main) == main;
        }
    }

    /// <summary>Begins each member that Unity's native code keeps to the main thread: with collections checks the build puts
    /// it there, by the table of threads. Jobs have none, wherever they run: which thread takes a job is luck.</summary>
    internal static void Require(string member)
    {
        if (JobThread.IsExecuting || !IsCurrent)
            throw new UnityException(member + " can only be called from the main thread.\n"
                + "Constructors and field initializers will be executed from the loading thread when loading a scene.\n"
                + "Don't use this function in the constructor or field initializers, instead move initialization code to the "
                + "Awake or Start function.");
    }
}
