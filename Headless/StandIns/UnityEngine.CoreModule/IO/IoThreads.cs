using System;
using System.Collections.Generic;
using System.Threading;

namespace StandIns.Io
{
    /// <summary>Two threads that open, read and close files, first come first served.</summary>
    static class IoThreads
    {
        const int Count = 2;

        static readonly object s_gate = new object();
        static readonly Queue<Action> s_queue = new Queue<Action>();
        static int s_started;
        static int s_sleepers;
        static bool s_paused;

        internal static void Enqueue(Action work)
        {
            lock (s_gate)
            {
                s_queue.Enqueue(work);
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
                }
                work();
            }
        }
    }
}
