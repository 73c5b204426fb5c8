using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using FastPoints.Base;
using FastPoints.Convert;
using FastPoints.Files;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Samplers;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>Frames of 16 ms beside a build, as an editor runs it: a worker for each core but one, one chain of the build less
    /// than there are workers, a tick of the pump a frame. Each frame has a few small jobs of its own and waits for them before
    /// it ends: how long, is the error. Points are those of the build.</summary>
    public struct FrameBesideBuildWorkload : IWorkload
    {
        const double FrameMs = 16, TickMs = 2;
        const int JobsPerFrame = 4;

        string m_source, m_target;
        NativeArray<uint> m_values;

        public string Name => "frame beside a build";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_source = TerrainBenchmarkFile.Make(context);
            m_target = Path.Combine(context.ScratchFolder, "frame.fastpoints");
            m_values = new NativeArray<uint>(JobsPerFrame, Allocator.Persistent);
        }

        public WorkloadResult Run()
        {
            int workers = JobsUtility.JobWorkerCount;
            JobsUtility.JobWorkerCount = Math.Max(1, Environment.ProcessorCount - 1);
            var waits = new SliceTimes(Allocator.Persistent);
            var ticks = new SliceTimes(Allocator.Persistent);
            ConvertResult result = null;
            int frames = 0;
            var settings = new ConvertSettings
            {
                Sampler = Sampler.Poisson,
                Workers = Math.Max(1, JobsUtility.JobWorkerCount - 1),
                Attributes = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue },
            };
            try
            {
                using var reader = PointReaders.Open(m_source);
                var pump = new WorkPump(ConvertCloud.Run(new[] { reader }, m_target, settings, r => result = r, null));
                try
                {
                    for (; !pump.IsDone; frames++)
                        RunFrame(pump, waits, ticks);
                }
                finally
                {
                    pump.Cancel();
                }
                return new WorkloadResult
                {
                    Points = result.Manifest.Points,
                    Bytes = reader.Info.FileBytes,
                    Error = waits.QuantileMs(0.99),
                    ErrorUnit = "ms p99 wait",
                    Note = string.Format(CultureInfo.InvariantCulture,
                        "{0} frames waited for their own jobs {1:0.0} ms (p50), "
                        + "{2:0.0} (p99), {3:0.0} (max), and for the pump {4:0.0}, {5:0.0}, {6:0.0}", frames,
                        waits.QuantileMs(0.5), waits.QuantileMs(0.99), waits.QuantileMs(1),
                        ticks.QuantileMs(0.5), ticks.QuantileMs(0.99), ticks.QuantileMs(1)),
                };
            }
            finally
            {
                waits.Dispose();
                ticks.Dispose();
                JobsUtility.JobWorkerCount = workers;
            }
        }

        public void Dispose()
        {
            if (m_values.IsCreated)
                m_values.Dispose();
            if (Directory.Exists(m_target))
                Directory.Delete(m_target, true);
        }

        void RunFrame(WorkPump pump, SliceTimes waits, SliceTimes ticks)
        {
            var watch = Stopwatch.StartNew();
            var own = new SmallJob { Values = m_values }.Schedule(JobsPerFrame, 1);
            JobHandle.ScheduleBatchedJobs();
            long begin = SliceTimes.Begin();
            pump.Tick(TickMs);
            ticks.End(begin);
            begin = SliceTimes.Begin();
            own.Complete();
            waits.End(begin);
            int left = (int)(FrameMs - watch.Elapsed.TotalMilliseconds);
            if (left > 0)
                Thread.Sleep(left);
        }

        /// <summary>About 50 us.</summary>
        [BurstCompile]
        struct SmallJob : IJobParallelFor
        {
            const int Steps = 20000;

            public NativeArray<uint> Values;

            public void Execute(int index)
            {
                uint value = Values[index] | 1;
                for (int i = 0; i < Steps; i++)
                {
                    value ^= value << 13;
                    value ^= value >> 17;
                    value ^= value << 5;
                }
                Values[index] = value;
            }
        }
    }
}
