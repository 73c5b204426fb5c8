using System;
using System.Threading;

namespace StandIns.Scheduling
{
    /// <summary>What a thread is to the job system.</summary>
    static class JobThread
    {
        [ThreadStatic]
        static int t_index;
        [ThreadStatic]
        static bool t_isWorker;
        [ThreadStatic]
        static int t_executing;

        static Thread s_main;

        /// <summary>0 on the main thread, workers from 1.</summary>
        internal static int Index => t_index;

        internal static bool IsWorker => t_isWorker;

        internal static bool IsExecuting => t_executing != 0;

        internal static void BecomeWorker(int index)
        {
            t_index = index;
            t_isWorker = true;
        }

        internal static void Enter() => t_executing++;

        internal static void Leave() => t_executing--;

        /// <summary>Makes the calling thread the main thread.</summary>
        internal static void BecomeMain() => s_main = Thread.CurrentThread;

        /// <summary>
        /// Whether the calling thread is the main thread: the first that used the job system, or, that one being gone, the next.
        /// </summary>
        internal static bool IsMain()
        {
            Thread current = Thread.CurrentThread;
            if (s_main == current)
                return true;
            Thread main = s_main;
            if (t_isWorker || (main != null && main.IsAlive))
                return false;
            return Interlocked.CompareExchange(ref s_main, current, main) == main;
        }
    }
}
