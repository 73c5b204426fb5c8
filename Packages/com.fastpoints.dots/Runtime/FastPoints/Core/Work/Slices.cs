using System;
using System.Collections.Generic;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Core
{
    /// <summary>Work on a range that is cut into short jobs. All of them are scheduled ahead: if each were awaited before the
    /// next one, a tick of the pump would bring it on by one slice.</summary>
    internal static class Slices
    {
        /// <summary>Jobs to schedule in one step: a fraction of a millisecond of the main thread.</summary>
        const int JobsPerStep = 16;

        /// <summary>Steps whose jobs are in flight at most: about a second's work.</summary>
        const int StepsAhead = 32;

        /// <summary>Chains that all workers, and a thread that waits, can run side by side.</summary>
        public static int Lanes => Math.Max(1, JobsUtility.JobWorkerCount) + 1;

        /// <summary>Work for a pump: the range in slices, each after the one before in its lane.</summary>
        /// <param name="schedule">Schedules the slice from its first to before its second argument, after the third.</param>
        /// <param name="lanes">Chains side by side.</param>
        /// <param name="inputDeps">What the first slices come behind; it is complete in the end.</param>
        public static IEnumerator<Work> Run(int begin, int end, int perSlice, Func<int, int, JobHandle, JobHandle> schedule,
            int lanes = 1, JobHandle inputDeps = default)
        {
            var all = inputDeps;
            try
            {
                yield return Work.Of(Schedule(begin, end, perSlice, schedule, lanes, inputDeps, scheduled => all = scheduled));
                yield return all;
            }
            finally
            {
                all.Complete();
            }
        }

        /// <summary>The same without awaiting the last slices.</summary>
        /// <param name="scheduled">Receives the handle of all slices.</param>
        public static IEnumerator<Work> Schedule(int begin, int end, int perSlice,
            Func<int, int, JobHandle, JobHandle> schedule, int lanes, JobHandle inputDeps, Action<JobHandle> scheduled)
        {
            var last = new JobHandle[lanes];
            var steps = new Queue<JobHandle>();
            bool isWhole = false;
            try
            {
                for (int lane = 0; lane < lanes; lane++)
                    last[lane] = inputDeps;
                for (int first = begin, n = 1; first < end; first += Math.Min(perSlice, end - first), n++)
                {
                    int lane = n % lanes;
                    last[lane] = schedule(first, first + Math.Min(perSlice, end - first), last[lane]);
                    if (n % JobsPerStep != 0)
                        continue;
                    JobHandle.ScheduleBatchedJobs();
                    steps.Enqueue(All(last));
                    yield return steps.Count > StepsAhead ? steps.Dequeue() : default;
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
