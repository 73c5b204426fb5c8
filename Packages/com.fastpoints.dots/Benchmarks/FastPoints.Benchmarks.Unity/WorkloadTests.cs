using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using Unity.Burst;
using Unity.PerformanceTesting;

namespace FastPoints.Benchmarks
{
    /// <summary>Each workload as a performance test: warm-up, then samples in turns with the workload that bounds it.
    /// <c>fastpoints bench</c> times the same workloads, and gives its results the same names, so that runs of both can be laid
    /// side by side.</summary>
    public sealed class WorkloadTests
    {
        const int Points = 1_000_000;
        const string DataVariable = "FASTPOINTS_DATA";

        bool m_wasSynchronous;

        static IEnumerable<string> Names() => WorkloadList.All().Select(w => w.Name);

        /// <summary>The editor runs managed code until Burst's has been compiled.</summary>
        [OneTimeSetUp]
        public void CompileBurstFirst()
        {
            m_wasSynchronous = BurstCompiler.Options.EnableBurstCompileSynchronously;
            BurstCompiler.Options.EnableBurstCompileSynchronously = true;
        }

        [OneTimeTearDown]
        public void CompileBurstAsBefore() => BurstCompiler.Options.EnableBurstCompileSynchronously = m_wasSynchronous;

        [Test, Performance, TestCaseSource(nameof(Names))]
        public void Run(string workload)
        {
            List<IWorkload> all = WorkloadList.All();
            List<IWorkload> group = WorkloadTurns.Groups(all, all.Where(w => w.Name == workload)).Single();
            string scratch = Path.Combine(Path.GetTempPath(), "fastpoints-workload-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(scratch);
            try
            {
                var context = new WorkloadContext { ScratchFolder = scratch, Points = Points, DataFolder = DataFolder() };
                using var allocated = new AllocatedBytes();
                var settings = new TurnSettings { AllocatedBytes = () => allocated.Now };
                WorkloadSamples samples = WorkloadTurns.Run(group, context, settings).Single(s => s.Name == workload);
                if (!samples.HadInput)
                    Assert.Ignore("wants real clouds: " + DataVariable + " names their folder");
                Save(samples.Series().Where(s => allocated.IsCounted || s.Name != WorkloadSamples.Garbage));
                if (samples.Note != null)
                    TestContext.WriteLine(samples.Note);
            }
            finally
            {
                Directory.Delete(scratch, true);
            }
        }

        static void Save(IEnumerable<SampleSeries> series)
        {
            foreach (SampleSeries one in series)
            {
                var group = new SampleGroup(one.Name, (SampleUnit)one.Unit, one.IncreaseIsBetter);
                foreach (double sample in one.Samples)
                    Measure.Custom(group, sample);
            }
        }

        static string DataFolder()
        {
            string folder = Environment.GetEnvironmentVariable(DataVariable);
            return folder != null && Directory.Exists(folder) ? folder : null;
        }
    }
}
