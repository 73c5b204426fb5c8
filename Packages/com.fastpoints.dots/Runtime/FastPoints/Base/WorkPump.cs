using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Unity.Jobs;

namespace FastPoints.Base
{
    /// <summary>
    /// Drives work that is written as an iterator: each step schedules jobs and yields the handle that must be finished before
    /// the next step can run. An editor calls <see cref="Tick"/> once an update and never waits; the converter calls
    /// <see cref="RunToEnd"/>, which waits.
    /// </summary>
    /// <remarks>
    /// Work owns what it allocates: its <c>finally</c> blocks run when it ends, when it throws and when <see cref="Cancel"/>
    /// disposes it, and they complete the jobs that are still in flight before they free memory.
    /// </remarks>
    public sealed class WorkPump
    {
        readonly IEnumerator<JobHandle> m_work;
        readonly Stopwatch m_tickWatch = new Stopwatch();
        JobHandle m_awaited;

        public WorkPump(IEnumerator<JobHandle> work)
        {
            m_work = work;
        }

        public bool IsDone { get; private set; }

        /// <summary>
        /// Runs steps whose jobs are finished until <paramref name="budgetMs"/> is used up or a job is still running.
        /// </summary>
        /// <returns>Whether the work is done.</returns>
        public bool Tick(double budgetMs)
        {
            m_tickWatch.Restart();
            while (!IsDone && m_awaited.IsCompleted && m_tickWatch.Elapsed.TotalMilliseconds < budgetMs)
                Step();
            JobHandle.ScheduleBatchedJobs();
            return IsDone;
        }

        /// <summary>Ends the work: jobs in flight are awaited, what it allocated is freed.</summary>
        public void Cancel()
        {
            if (IsDone)
                return;
            IsDone = true;
            m_work.Dispose();
        }

        /// <summary>Runs the work on the calling thread until it is done.</summary>
        /// <exception cref="System.OperationCanceledException">The token was cancelled; everything is freed.</exception>
        public static void RunToEnd(IEnumerator<JobHandle> work, CancellationToken cancellation = default)
        {
            var pump = new WorkPump(work);
            try
            {
                while (!pump.IsDone)
                {
                    cancellation.ThrowIfCancellationRequested();
                    pump.Step();
                    // A step that awaits no job may wait for another thread.
                    Thread.Yield();
                }
            }
            finally
            {
                pump.Cancel();
            }
        }

        void Step()
        {
            m_awaited.Complete();
            m_awaited = default;
            bool more = false;
            try
            {
                more = m_work.MoveNext();
            }
            finally
            {
                if (!more)
                {
                    IsDone = true;
                    m_work.Dispose();
                }
            }
            if (more)
                m_awaited = m_work.Current;
        }
    }
}
