using System;
using System.Collections.Generic;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints
{
    // Work on a range that is cut into short jobs. All are scheduled ahead: if each were awaited before the next one, a tick of
    // the coroutine would bring it on by one slice.
    internal static class Slices
    {
        const int JobsPerStep = 16; // A fraction of a millisecond of the main thread.
        const int MaxStepsInFlight = 32; // About a second's work.
        public static int MaxChains => Math.Max(1, JobsUtility.JobWorkerCount) + 1; // All workers and a waiting thread.

        public static IEnumerator<JobStep> Run(int begin, int end, int perSlice, Func<int, int, JobHandle, JobHandle> schedule,
            int chains = 1, JobHandle inputDeps = default)
        {
            var all = inputDeps;
            try
            {
                yield return JobStep.Of(Schedule(end - begin, perSlice, (first, stop, after) =>
                    schedule(begin + first, begin + stop, after), chains, inputDeps, scheduled => all = scheduled));
                yield return all;
            }
            finally
            {
                all.Complete();
            }
        }

        public static IEnumerator<JobStep> Schedule(int count, int perSlice, Func<int, int, JobHandle, JobHandle> schedule,
            int chains, JobHandle inputDeps, Action<JobHandle> scheduled)
        {
            var last = new JobHandle[chains];
            var steps = new Queue<JobHandle>();
            bool isWhole = false;
            try
            {
                for (int chain = 0; chain < chains; chain++)
                    last[chain] = inputDeps;
                for (int first = 0, n = 1; first < count; first += Math.Min(perSlice, count - first), n++)
                {
                    int chain = n % chains;
                    last[chain] = schedule(first, first + Math.Min(perSlice, count - first), last[chain]);
                    if (n % JobsPerStep != 0)
                        continue;
                    JobHandle.ScheduleBatchedJobs();
                    steps.Enqueue(All(last));
                    yield return steps.Count > MaxStepsInFlight ? steps.Dequeue() : default;
                }
                scheduled(All(last));
                isWhole = true;
            }
            finally
            {
                if (!isWhole)
                    All(last).Complete();
            }
        }

        static JobHandle All(JobHandle[] handles)
        {
            var all = handles[0];
            for (int i = 1; i < handles.Length; i++)
                all = JobHandle.CombineDependencies(all, handles[i]);
            return all;
        }
    }
}
