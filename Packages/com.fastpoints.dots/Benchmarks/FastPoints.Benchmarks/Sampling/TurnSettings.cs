using System;
using System.Threading;

namespace FastPoints.Benchmarks
{
    /// <summary>How workloads are timed.</summary>
    public sealed class TurnSettings
    {
        /// <summary>Samples of each workload.</summary>
        public int Turns = 7;

        /// <summary>Managed bytes that were allocated until now, on all threads.</summary>
        public Func<long> AllocatedBytes = () => 0;

        /// <summary>Told the share of the turns that is done, 0 to 1; or null.</summary>
        public Action<double> Progress;

        public CancellationToken Cancellation;

        /// <summary>Runs before the first timed one: a run-time compiler compiles its last tier in the background after 30 calls
        /// and a pause in which nothing new is called. Long runs call enough within themselves.</summary>
        public int WarmUpRuns = 40;
        public int FewestWarmUpRuns = 3;
        public double WarmUpMs = 400;
        public double LongWarmUpMs = 1500;

        /// <summary>Shorter runs are repeated within one sample, since clocks and schedulers blur them.</summary>
        public double ShortestSampleMs = 5;

        public bool IsWarm(int runs, double ms) =>
            (runs >= WarmUpRuns && ms >= WarmUpMs) || (runs >= FewestWarmUpRuns && ms >= LongWarmUpMs);
    }
}
