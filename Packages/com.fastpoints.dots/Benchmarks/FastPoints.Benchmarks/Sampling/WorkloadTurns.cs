using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;

namespace FastPoints.Benchmarks
{
    /// <summary>Times workloads that bound one another in turns, so that all see the same moments of a busy machine.</summary>
    public static class WorkloadTurns
    {
        /// <summary>The workloads that are asked for and, before them, those that bound them, by the limit that they share:
        /// a workload without its limit would be a time without a meaning.</summary>
        public static IEnumerable<List<IWorkload>> Groups(IReadOnlyList<IWorkload> all, IEnumerable<IWorkload> asked)
        {
            var chosen = asked.ToList();
            chosen.AddRange(all.Where(w => chosen.Any(c => c.LimitName == w.Name) && !chosen.Contains(w)).ToList());
            return chosen.GroupBy(w => w.LimitName ?? w.Name)
                .Select(group => group.OrderBy(w => w.LimitName == null ? 0 : 1).ToList());
        }

        public static List<WorkloadSamples> Run(IReadOnlyList<IWorkload> group, WorkloadContext context, TurnSettings settings)
        {
            var samples = new List<WorkloadSamples>();
            var repeats = new int[group.Count];
            try
            {
                for (int i = 0; i < group.Count; i++)
                {
                    settings.Cancellation.ThrowIfCancellationRequested();
                    group[i].Prepare(context);
                    repeats[i] = (int)Math.Max(1, Math.Min(1000, settings.ShortestSampleMs / WarmUp(group[i], settings)));
                    samples.Add(new WorkloadSamples(group[i].Name, samples.Find(s => s.Name == group[i].LimitName)));
                }
                for (int turn = 0; turn < settings.Turns; turn++)
                    for (int i = 0; i < group.Count; i++)
                    {
                        settings.Cancellation.ThrowIfCancellationRequested();
                        TakeSample(group[i], repeats[i], settings, samples[i]);
                        settings.Progress?.Invoke((double)(turn * group.Count + i + 1) / (settings.Turns * group.Count));
                    }
                return samples;
            }
            finally
            {
                foreach (var workload in group)
                    workload.Dispose();
            }
        }

        static void TakeSample(IWorkload workload, int repeats, TurnSettings settings, WorkloadSamples samples)
        {
            long allocated = settings.AllocatedBytes();
            WorkloadResult result = default;
            var watch = Stopwatch.StartNew();
            for (int repeat = 0; repeat < repeats; repeat++)
                result = workload.Run();
            double ms = watch.Elapsed.TotalMilliseconds / repeats;
            samples.Add(ms, (double)(settings.AllocatedBytes() - allocated) / repeats, result);
        }

        static double WarmUp(IWorkload workload, TurnSettings settings)
        {
            var watch = Stopwatch.StartNew();
            int runs = 0;
            for (; !settings.IsWarm(runs, watch.Elapsed.TotalMilliseconds); runs++)
                workload.Run();
            return Math.Max(1e-6, watch.Elapsed.TotalMilliseconds / Math.Max(1, runs));
        }
    }

    public sealed class TurnSettings
    {
        public int Turns = 7;

        /// <summary>Managed bytes that were allocated until now, on all threads.</summary>
        public Func<long> AllocatedBytes = () => 0;

        /// <summary>Told the share of the turns that is done, 0 to 1; or null.</summary>
        public Action<double> Progress;

        public CancellationToken Cancellation;

        /// <summary>Runs before the first timed one: a run-time compiler compiles its last tier in the background after 30 calls
        /// and a pause in which nothing new is called. Long runs call enough within themselves.</summary>
        public int WarmUpRuns = 40;
        public int MinWarmUpRuns = 3;
        public double WarmUpMs = 400;
        public double LongWarmUpMs = 1500;

        /// <summary>Shorter runs are repeated within one sample, since clocks and schedulers blur them.</summary>
        public double ShortestSampleMs = 5;

        public bool IsWarm(int runs, double ms) =>
            (runs >= WarmUpRuns && ms >= WarmUpMs) || (runs >= MinWarmUpRuns && ms >= LongWarmUpMs);
    }
}
