using System.Collections.Generic;
using Unity.Jobs;

namespace FastPoints.Evaluation
{
    internal static class CoroutineGroup
    {
        // Coroutine: steps in turn all that are ready, and awaits the oldest where none is, so that workers have the jobs of
        // all of them. They begin in their order, when there is room, and end as their jobs do.
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

        // The first from a place on, in a circle, whose jobs have ended; -1 for none.
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
