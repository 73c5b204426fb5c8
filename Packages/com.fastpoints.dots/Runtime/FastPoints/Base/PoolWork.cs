using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;

namespace FastPoints.Base
{
    /// <summary>Looks at files beside the main thread: opens them, asks for lengths, reads what AsyncReadManager has no use for.
    /// Whoever takes what came of it meets no exception but a <see cref="PointCloudException"/>, whatever was thrown
    /// there.</summary>
    public static class PoolWork
    {
        /// <summary>Begins work on a thread of the pool.</summary>
        /// <param name="path">The file or folder that it is about, for messages.</param>
        /// <param name="work">Uses nothing that anybody else changes: when nobody wants it any more, it goes on.</param>
        /// <param name="unwanted">Frees what nobody took when the work was disposed, on whatever thread that is.</param>
        public static PoolWork<T> Begin<T>(string path, Func<T> work, Action<T> unwanted = null) =>
            new PoolWork<T>(path, work, unwanted);

        /// <summary>The same as work for a pump; done where it is pumped, where that is a thread of the pool.</summary>
        /// <param name="done">Takes what came of it, on the pump's thread.</param>
        /// <param name="unwanted">Frees what came too late for that, on whatever thread that is.</param>
        public static IEnumerator<Work> Run<T>(string path, Func<T> work, Action<T> done, Action<T> unwanted = null)
        {
            if (Thread.CurrentThread.IsThreadPoolThread)
            {
                done(work());
                yield break;
            }
            using (var begun = Begin(path, work, unwanted))
            {
                while (!begun.IsDone)
                    yield return default;
                done(begun.Take());
            }
        }
    }

    /// <summary>Work that goes on, or has ended, on a thread of the pool. For one thread, which takes what comes of it.</summary>
    public sealed class PoolWork<T> : IDisposable
    {
        readonly string m_path;
        readonly Task<T> m_task;
        readonly Action<T> m_unwanted;
        bool m_isTaken;

        internal PoolWork(string path, Func<T> work, Action<T> unwanted)
        {
            m_path = path;
            m_unwanted = unwanted;
            m_task = Task.Run(work);
        }

        public bool IsDone => m_task.IsCompleted;

        /// <summary>What came of it; the caller's from now on. Waits where it goes on.</summary>
        /// <exception cref="PointCloudException">What was thrown; with <see cref="FailureCode.Unexpected"/> where that was another
        /// exception.</exception>
        public T Take()
        {
            m_isTaken = true;
            try
            {
                return m_task.GetAwaiter().GetResult();
            }
            catch (Exception e)
            {
                throw PointCloudException.Of(m_path, e);
            }
        }

        /// <summary>The same for somebody who only wants to dispose it: nothing where it failed.</summary>
        public T TakeIfSound()
        {
            try
            {
                return Take();
            }
            catch (PointCloudException)
            {
                // Nobody asks for it any more.
                return default;
            }
        }

        /// <summary>Has what came of it freed, if nobody took it: now, or where it goes on, on its thread when it
        /// ends.</summary>
        public void Dispose()
        {
            if (m_isTaken || m_unwanted == null)
                return;
            m_isTaken = true;
            m_task.ContinueWith(t => m_unwanted(t.Result),
                TaskContinuationOptions.OnlyOnRanToCompletion | TaskContinuationOptions.ExecuteSynchronously);
        }
    }
}
