using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Looks at files beside the main thread: opens, asks for lengths, reads what AsyncReadManager has no use
    /// for.</summary>
    static class PoolWork
    {
        /// <summary>Work for a pump: runs something on a thread of the pool; or where it is pumped, where that is one.</summary>
        /// <param name="work">Uses nothing that anybody else changes: when the pump gives up, it goes on.</param>
        /// <param name="done">Takes what came of it, on the pump's thread.</param>
        public static IEnumerator<JobHandle> Run<T>(Func<T> work, Action<T> done)
        {
            if (Thread.CurrentThread.IsThreadPoolThread)
            {
                done(work());
                yield break;
            }
            var task = Task.Run(work);
            while (!task.IsCompleted)
                yield return default;
            done(task.GetAwaiter().GetResult());
        }
    }
}
