using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using FastPoints.Benchmarks;

namespace FastPoints.Cli
{
    /// <summary>What one workload took: medians over its timed runs.</summary>
    public sealed class Measurement
    {
        /// <summary>Before the first timed run: the JIT compiles its last tier in the background after 30 calls and a pause in
        /// which nothing new is called. Long runs call enough within themselves.</summary>
        const int WarmUpRuns = 40;
        const int FewestWarmUpRuns = 3;
        const double WarmUpMs = 400;
        const double LongWarmUpMs = 1500;

        /// <summary>Shorter runs are repeated within one sample, since clocks and schedulers blur them.</summary>
        const double ShortestSampleMs = 5;

        public required string Name { get; init; }
        public required string? LimitName { get; init; }
        public double Ms { get; private set; }
        public long Points { get; private set; }
        public long Bytes { get; private set; }
        public double Error { get; private set; }
        public string? ErrorUnit { get; private set; }
        public string? Note { get; private set; }

        /// <summary>Managed bytes that one run allocates, on all threads.</summary>
        public long GarbageBytes { get; private set; }

        public double PointsPerSecond => Ms > 0 ? Points / Ms * 1000 : 0;
        public double BytesPerSecond => Ms > 0 ? Bytes / Ms * 1000 : 0;

        /// <summary>Time by point (by byte where no points are counted) over that of the limit.</summary>
        public double RatioTo(Measurement limit) =>
            Points > 0 && limit.Points > 0 ? Ms / Points / (limit.Ms / limit.Points)
            : Bytes > 0 && limit.Bytes > 0 ? Ms / Bytes / (limit.Ms / limit.Bytes)
            : Ms / limit.Ms;

        /// <summary>Measures workloads that bound one another, in turns.</summary>
        public static List<Measurement> Take(List<IWorkload> workloads, WorkloadContext context, int runs, CliRun run)
        {
            var results = new List<Measurement>();
            var samples = workloads.Select(_ => new List<double>()).ToList();
            var repeats = new int[workloads.Count];
            run.Progress.Begin(workloads[0].Name);
            try
            {
                for (int i = 0; i < workloads.Count; i++)
                {
                    run.Cancellation.ThrowIfCancellationRequested();
                    var workload = workloads[i];
                    workload.Prepare(context);
                    var warming = Stopwatch.StartNew();
                    int warmUps = 0;
                    for (; !IsWarm(warmUps, warming.Elapsed.TotalMilliseconds); warmUps++)
                        workload.Run();
                    repeats[i] = (int)Math.Clamp(ShortestSampleMs / (warming.Elapsed.TotalMilliseconds / warmUps), 1, 1000);
                    long before = GC.GetTotalAllocatedBytes(true);
                    var result = workload.Run();
                    long garbage = GC.GetTotalAllocatedBytes(true) - before;
                    results.Add(new Measurement
                    {
                        Name = workload.Name,
                        LimitName = workload.LimitName,
                        Points = result.Points,
                        Bytes = result.Bytes,
                        Error = result.Error,
                        ErrorUnit = result.ErrorUnit,
                        Note = result.Note,
                        GarbageBytes = garbage,
                    });
                }
                for (int sample = 0; sample < runs; sample++)
                    for (int i = 0; i < workloads.Count; i++)
                    {
                        run.Cancellation.ThrowIfCancellationRequested();
                        var watch = Stopwatch.StartNew();
                        for (int repeat = 0; repeat < repeats[i]; repeat++)
                            workloads[i].Run();
                        samples[i].Add(watch.Elapsed.TotalMilliseconds / repeats[i]);
                        run.Progress.Report((double)(sample * workloads.Count + i + 1) / (runs * workloads.Count), 0, 0);
                    }
                for (int i = 0; i < workloads.Count; i++)
                    results[i].Ms = Median(samples[i]);
                return results;
            }
            finally
            {
                foreach (var workload in workloads)
                    workload.Dispose();
                run.Progress.End();
            }
        }

        static bool IsWarm(int runs, double ms) =>
            (runs >= WarmUpRuns && ms >= WarmUpMs) || (runs >= FewestWarmUpRuns && ms >= LongWarmUpMs);

        static double Median(List<double> values)
        {
            values.Sort();
            int middle = values.Count / 2;
            return values.Count % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
        }
    }
}
