using System;
using System.Collections.Concurrent;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace StandIns.Scheduling
{
    /// <summary>
    /// An exception that a job threw. Unity logs it and lets dependent jobs run; here it also goes along the dependencies to the
    /// first Complete that waits for the job, and is thrown there, once.
    /// </summary>
    sealed class JobFault
    {
        static readonly ConcurrentQueue<JobFault> s_all = new ConcurrentQueue<JobFault>();

        readonly ExceptionDispatchInfo m_exception;
        readonly string m_job;
        int m_thrown;

        static JobFault()
        {
            AppDomain.CurrentDomain.ProcessExit += (sender, args) => ReportUnseen();
        }

        internal JobFault(Exception exception, string job)
        {
            m_exception = ExceptionDispatchInfo.Capture(exception);
            m_job = job;
            s_all.Enqueue(this);
            while (s_all.TryPeek(out JobFault oldest) && oldest.m_thrown != 0)
                s_all.TryDequeue(out _);
        }

        internal void ThrowOnce()
        {
            if (Interlocked.Exchange(ref m_thrown, 1) == 0)
                m_exception.Throw();
        }

        static void ReportUnseen()
        {
            while (s_all.TryDequeue(out JobFault fault))
                if (fault.m_thrown == 0)
                    UnityEngine.Debug.LogError(
                        $"{fault.m_job} threw, and nobody completed it: {fault.m_exception.SourceException}");
        }
    }
}
