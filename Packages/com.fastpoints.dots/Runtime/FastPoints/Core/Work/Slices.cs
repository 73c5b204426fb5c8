using System;
using System.Collections.Generic;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Core
{
    /// <summary>Work on a range that is cut into short jobs. All of them are scheduled ahead: if each were awaited before the
    /// next one, a tick of the coroutine would bring it on by one slice.</summary>
    internal static class Slices
    {
        /// <summary>Jobs to schedule in one step: a fraction of a millisecond of the main thread.</summary>
        const int JobsPerStep = 16;

        /// <summary>Steps whose jobs are in flight at most: about a second's work.</summary>
        const int MaxStepsInFlight = 32;

        /// <summary>Chains that all workers, and a thread that waits, can run side by side.</summary>
        public static int MaxChains => Math.Max(1, JobsUtility.JobWorkerCount) + 1;

        /// <summary>Coroutine: the range in slices, each after the one before in its lane.</summary>
        /// <param name="schedule">Schedules the slice from its first to before its second argument, after the third.</param>
        /// <param name="chains">Chains side by side.</param>
        /// <param name="inputDeps">What the first slices come behind; it is complete in the end.</param>
        public static IEnumerator<JobStep> Run(int begin, int end, int perSlice, Func<int, int, JobHandle, JobHandle> schedule,
            int chains = 1, JobHandle inputDeps = default)
        {
            var all = inputDeps;
            try
            {
                yield return JobStep.Of(Schedule(begin, end, perSlice, schedule, chains, inputDeps, scheduled =>
                    all = scheduled));
                yield return all;
            }
            finally
            {
                all.Complete();
            }
        }

        /// <summary>The same without awaiting the last slices.</summary>
        /// <param name="scheduled">Receives the handle of all slices.</param>
        public static IEnumerator<JobStep> Schedule(int begin, int end, int perSlice,
            Func<int, int, JobHandle, JobHandle> schedule, int chains, JobHandle inputDeps, Action<JobHandle> scheduled)
        {
            var last = new JobHandle[chains];
            var steps = new Queue<JobHandle>();
            bool isWhole = false;
            try
            {
                for (int chain = 0; chain < chains; chain++)
                    last[chain] = inputDeps;
                for (int first = begin, n = 1; first < end; first += Math.Min(perSlice, end - first), n++)
                {
                    int chain = n % chains;
                    last[chain] = schedule(first, first + Math.Min(perSlice, end - first), last[chain]);
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
