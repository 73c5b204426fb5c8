using System.Collections.Generic;
using Unity.Jobs;

namespace FastPoints.Core
{
    /// <summary>Runs several pieces of work side by side, so that workers have the jobs of all of them at once.</summary>
    internal static class CoroutineGroup
    {
        /// <summary>Coroutine: steps in turn all that are ready, and awaits the oldest where none is. It begins them in
        /// their order; which ends first depends on their jobs.</summary>
        /// <param name="coroutines">Taken when there is room for one more; each is disposed when it ends.</param>
        /// <param name="maxInFlight">The most at work, which determine the memory.</param>
        public static IEnumerator<JobStep> Run(IEnumerable<IEnumerator<JobStep>> coroutines, int maxInFlight)
        {
            var running = new List<CoroutineStack>();
            var source = coroutines.GetEnumerator();
            try
            {
                bool hasMore = true;
                for (int next = 0; hasMore || running.Count > 0;)
                {
                    int at = hasMore && running.Count < maxInFlight ? running.Count : FindReady(running, next);
                    if (at < 0)
                    {
                        JobHandle.ScheduleBatchedJobs();
                        yield return running[0].Current;
                        continue;
                    }
                    if (at == running.Count)
                    {
                        if (!(hasMore = source.MoveNext()))
                            continue;
                        running.Add(new CoroutineStack(source.Current));
                    }
                    running[at].Current.Complete();
                    next = at + 1;
                    if (!running[at].MoveNext())
                    {
                        running.RemoveAt(at);
                        next = at;
                    }
                    // The coroutine checks its budget.
                    yield return default;
                }
            }
            finally
            {
                foreach (var work in running)
                    work.Dispose();
                source.Dispose();
            }
        }

        /// <summary>The first from a place on, in a circle, whose jobs have ended; -1 for none.</summary>
        static int FindReady(List<CoroutineStack> coroutines, int from)
        {
            for (int i = 0; i < coroutines.Count; i++)
            {
                int at = (from + i) % coroutines.Count;
                if (JobCoroutine.HasEnded(coroutines[at].Current))
                    return at;
            }
            return -1;
        }
    }
}
