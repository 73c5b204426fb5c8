using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints
{
    /// <summary>One step of work: jobs that must finish before the next step can run, or other work to do first.</summary>
    public readonly struct JobStep
    {
        internal readonly JobHandle Jobs;
        internal readonly IEnumerator<JobStep> Inner;

        JobStep(JobHandle jobs, IEnumerator<JobStep> inner) => (Jobs, Inner) = (jobs, inner);

        /// <summary>Runs all steps of another piece of work, which is disposed when it ends or its parent is.</summary>
        public static JobStep Of(IEnumerator<JobStep> inner) => new JobStep(default, inner);

        // Coroutine: these jobs, whose end is awaited also where the work is cancelled, which then frees what they use.
        internal static IEnumerator<JobStep> Await(JobHandle jobs)
        {
            try
            {
                yield return jobs;
            }
            finally
            {
                jobs.Complete();
            }
        }

        public static implicit operator JobStep(JobHandle jobs) => new JobStep(jobs, null);
    }

    // Iterates the steps of work and of all work nested in it, as handles to await. It disposes from the inside out.
    internal sealed class CoroutineStack : IEnumerator<JobHandle>
    {
        readonly Stack<IEnumerator<JobStep>> m_stack = new Stack<IEnumerator<JobStep>>();

        public CoroutineStack(IEnumerator<JobStep> work) => m_stack.Push(work);

        public JobHandle Current { get; private set; }

        object IEnumerator.Current => Current;

        public bool MoveNext()
        {
            bool isWhole = false;
            try
            {
                bool more = Next();
                isWhole = true;
                return more;
            }
            finally
            {
                if (!isWhole)
                    Dispose();
            }
        }

        public void Dispose()
        {
            if (m_stack.Count == 0)
                return;
            try
            {
                m_stack.Pop().Dispose();
            }
            finally
            {
                Dispose();
            }
        }

        void IEnumerator.Reset() => throw new NotSupportedException();

        bool Next()
        {
            while (m_stack.Count > 0)
            {
                var innermost = m_stack.Peek();
                if (!innermost.MoveNext())
                {
                    m_stack.Pop().Dispose();
                }
                else if (innermost.Current.Inner != null)
                {
                    m_stack.Push(innermost.Current.Inner);
                }
                else
                {
                    Current = innermost.Current.Jobs;
                    return true;
                }
            }
            Current = default;
            return false;
        }
    }

    /// <summary>Drives work that is written as an iterator: each step schedules jobs and yields the handle that must complete
    /// before the next step, or work to do first. An editor calls <see cref="Tick"/> once an update and never waits; a
    /// converter calls <see cref="RunToEnd"/>. Work owns what it allocates: its <c>finally</c> blocks, which also Cancel runs,
    /// complete jobs in flight and free memory.</summary>
    public sealed class JobCoroutine
    {
        // How long a tick spins until a job that it began has ended, and after how many failed spins, one after another, the
        // ticks between two of them no longer double.
        const double SpinMs = 1;
        const int MaxFailedSpins = 4;

        // A tick with a larger budget belongs to an editor without focus, not to a smooth frame: it waits for jobs throughout.
        const double MaxFrameMs = 16;

        static readonly Func<double> s_nowMs = () => Stopwatch.GetTimestamp() * (1000.0 / Stopwatch.Frequency);

        readonly CoroutineStack m_work;
        readonly Func<double> m_nowMs;
        JobHandle m_awaited;
        int m_failedSpins;
        int m_ticksUntilSpin;

        public JobCoroutine(IEnumerator<JobStep> work) : this(work, s_nowMs)
        {
        }

        internal JobCoroutine(IEnumerator<JobStep> work, Func<double> nowMs)
        {
            m_work = new CoroutineStack(work);
            m_nowMs = nowMs;
        }

        public bool IsDone { get; private set; }
        internal int FailedSpins { get; private set; }

        // Without worker threads jobs only run when awaited: it is run at once. Main thread.
        internal static bool HasEnded(JobHandle job)
        {
            if (JobsUtility.JobWorkerCount == 0)
                job.Complete();
            return job.IsCompleted;
        }

        /// <summary>Runs steps until the budget is used up or a job is still running. For a job that a step of this tick began
        /// it spins for a moment, unless earlier spins failed: otherwise many short jobs in a row would take a tick each.
        /// Returns whether the work is done.</summary>
        public bool Tick(double budgetMs)
        {
            double beginMs = m_nowMs();
            bool isAwaiting = false, isRare = budgetMs > MaxFrameMs;
            double spinUntilMs = 0;
            if (m_ticksUntilSpin > 0)
                m_ticksUntilSpin--;
            while (!IsDone && m_nowMs() - beginMs < budgetMs)
            {
                if (HasEnded(m_awaited))
                {
                    if (isAwaiting)
                        m_failedSpins = 0;
                    isAwaiting = false;
                    Step();
                    spinUntilMs = m_ticksUntilSpin == 0 ? m_nowMs() + SpinMs : 0;
                }
                else if (isRare || m_nowMs() < spinUntilMs)
                {
                    isAwaiting = true;
                    Thread.Yield();
                }
                else
                {
                    break;
                }
            }
            JobHandle.ScheduleBatchedJobs();
            if (!isAwaiting || isRare)
                return IsDone;
            FailedSpins++;
            m_ticksUntilSpin = 1 << (m_failedSpins = Math.Min(m_failedSpins + 1, MaxFailedSpins));
            return IsDone;
        }

        /// <summary>Ends the work: awaits jobs in flight and frees what the work allocated.</summary>
        public void Cancel()
        {
            if (IsDone)
                return;
            IsDone = true;
            m_work.Dispose();
        }

        /// <summary>Runs the work on the calling thread until it is done, or is cancelled and all is freed.</summary>
        public static void RunToEnd(IEnumerator<JobStep> work, CancellationToken cancellation = default)
        {
            var coroutine = new JobCoroutine(work);
            try
            {
                while (!coroutine.IsDone)
                {
                    cancellation.ThrowIfCancellationRequested();
                    coroutine.Step();
                    // A step that awaits no job may wait for another thread.
                    Thread.Yield();
                }
            }
            finally
            {
                coroutine.Cancel();
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
