using System.Diagnostics;
using System.Globalization;
using FastPoints.Benchmarks;

namespace FastPoints.MonoTests
{
    /// <summary>Runs the workloads of frames, whose notes say what the main thread takes: Mono runs that of Unity's editor. Jobs
    /// are managed code here as well, unlike in Unity, so that their speed means nothing.</summary>
    internal static class Bench
    {
        private const int Points = 1_000_000;

        public static int Run(string scratch)
        {
            string data = Environment.GetEnvironmentVariable("FASTPOINTS_DATA");
            var context = new WorkloadContext { ScratchFolder = scratch, Points = Points, DataFolder = data };
            Directory.CreateDirectory(scratch);
            foreach (IWorkload workload in WorkloadList.All()
                .Where(w => w.Name.StartsWith("frame ", StringComparison.Ordinal) || w.Name == "scene frames"))
                using (workload)
                {
                    workload.Prepare(context);
                    // In the first run code is compiled.
                    workload.Run();
                    Stopwatch watch = Stopwatch.StartNew();
                    WorkloadResult result = workload.Run();
                    Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0}: {1:0} ms; {2}", workload.Name,
                        watch.Elapsed.TotalMilliseconds, result.Note ?? "no input"));
                }
            return 0;
        }
    }
}
