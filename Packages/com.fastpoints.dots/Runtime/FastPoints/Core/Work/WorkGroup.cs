using System.Collections.Generic;
using Unity.Jobs;

namespace FastPoints.Core
{
    /// <summary>Runs several pieces of work side by side, so that workers have the jobs of all of them at once.</summary>
    internal static class WorkGroup
    {
        /// <summary>Work for a pump: steps in turn all that are ready, and awaits the oldest where none is. It begins them in
        /// their order; which ends first depends on their jobs.</summary>
        /// <param name="works">Taken when there is room for one more; each is disposed when it ends.</param>
        /// <param name="atOnce">The most at work, which determine the memory.</param>
        public static IEnumerator<Work> Run(IEnumerable<IEnumerator<Work>> works, int atOnce)
        {
            var inWork = new List<WorkSteps>();
            var source = works.GetEnumerator();
            try
            {
                bool hasMore = true;
                for (int next = 0; hasMore || inWork.Count > 0;)
                {
                    int at = hasMore && inWork.Count < atOnce ? inWork.Count : FindReady(inWork, next);
                    if (at < 0)
                    {
                        JobHandle.ScheduleBatchedJobs();
                        yield return inWork[0].Current;
                        continue;
                    }
                    if (at == inWork.Count)
                    {
                        if (!(hasMore = source.MoveNext()))
                            continue;
                        inWork.Add(new WorkSteps(source.Current));
                    }
                    inWork[at].Current.Complete();
                    next = at + 1;
                    if (!inWork[at].MoveNext())
                    {
                        inWork.RemoveAt(at);
                        next = at;
                    }
                    // The pump looks at its budget.
                    yield return default;
                }
            }
            finally
            {
                foreach (var work in inWork)
                    work.Dispose();
                source.Dispose();
            }
        }

        /// <summary>The first from a place on, in a circle, whose jobs have ended; -1 for none.</summary>
        static int FindReady(List<WorkSteps> works, int from)
        {
            for (int i = 0; i < works.Count; i++)
            {
                int at = (from + i) % works.Count;
                if (WorkPump.HasEnded(works[at].Current))
                    return at;
            }
            return -1;
        }
    }
}
