using System;
using System.Collections.Generic;
using System.Threading;

namespace StandIns.Io
{
    /// <summary>Two threads that open, read and close files, first come first served. A job thread with nothing to run helps: it
    /// takes the next read, and finds the bytes in its own cache when it decodes them.</summary>
    static class IoThreads
    {
        const int Count = 2;

        static readonly object s_gate = new object();
        static readonly Queue<Action> s_queue = new Queue<Action>();
        static int s_waiting;
        static int s_started;
        static int s_sleepers;
        static bool s_paused;

        internal static bool HasWaiting => Volatile.Read(ref s_waiting) > 0;

        internal static void Enqueue(Action work)
        {
            lock (s_gate)
            {
                s_queue.Enqueue(work);
                s_waiting++;
                if (s_sleepers == 0 && s_started < Count)
                {
                    s_started++;
                    new Thread(Run, 1 << 20) { IsBackground = true, Name = $"File reader {s_started}" }.Start();
                }
                Monitor.Pulse(s_gate);
            }
        }

        /// <summary>Holds back what has not begun, so that a test can look at reads in progress.</summary>
        internal static void Pause(bool paused)
        {
            lock (s_gate)
            {
                s_paused = paused;
                Monitor.PulseAll(s_gate);
            }
        }

        /// <summary>Does what is first in the queue on the calling thread, if there is something.</summary>
        internal static bool TryRunOne()
        {
            Action work;
            if (!HasWaiting)
                return false;
            lock (s_gate)
            {
                if (s_queue.Count == 0 || s_paused)
                    return false;
                work = s_queue.Dequeue();
                s_waiting--;
            }
            work();
            return true;
        }

        static void Run()
        {
            while (true)
            {
                Action work;
                lock (s_gate)
                {
                    while (s_queue.Count == 0 || s_paused)
                    {
                        s_sleepers++;
                        Monitor.Wait(s_gate);
                        s_sleepers--;
                    }
                    work = s_queue.Dequeue();
                    s_waiting--;
                }
                work();
            }
        }
    }
}
