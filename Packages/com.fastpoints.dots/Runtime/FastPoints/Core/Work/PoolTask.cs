using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;

namespace FastPoints
{
    /// <summary>Examines files on pool threads. What is thrown reaches the caller as a PointCloudException.</summary>
    public static class PoolTask
    {
        /// <summary>Begins work, which must not use anything that other code changes: it continues even when its result is no
        /// longer wanted. Unwanted results are freed on any thread. The path is for messages.</summary>
        public static PoolTask<T> Begin<T>(string path, Func<T> work, Action<T> unwanted = null) =>
            new PoolTask<T>(path, work, unwanted);

        /// <summary>The same as a coroutine, whose thread takes the result; on the pool it runs in place.</summary>
        public static IEnumerator<JobStep> Run<T>(string path, Func<T> work, Action<T> done, Action<T> unwanted = null)
        {
            if (Thread.CurrentThread.IsThreadPoolThread)
            {
                done(work());
                yield break;
            }
            using var begun = Begin(path, work, unwanted);
            while (!begun.IsDone)
                yield return default;
            done(begun.Take());
        }
    }

    /// <summary>Work that runs, or has ended, on a pool thread. One thread owns it and takes its result.</summary>
    public sealed class PoolTask<T> : IDisposable
    {
        readonly string m_path;
        readonly Task<T> m_task;
        readonly Action<T> m_unwanted;
        bool m_isTaken;

        internal PoolTask(string path, Func<T> work, Action<T> unwanted)
        {
            m_path = path;
            m_unwanted = unwanted;
            m_task = Task.Run(work);
        }

        public bool IsDone => m_task.IsCompleted;

        /// <summary>Hands over the result; waits while the work is running. Throws what was thrown there.</summary>
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

        /// <summary>The same for callers that only dispose the result: the default if the work failed.</summary>
        public T TakeOrDefault()
        {
            try
            {
                return Take();
            }
            catch (PointCloudException)
            {
                // The result is no longer wanted.
                return default;
            }
        }

        /// <summary>Frees the result if nobody took it: now, or, while the work is running, on its thread when it ends.</summary>
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
