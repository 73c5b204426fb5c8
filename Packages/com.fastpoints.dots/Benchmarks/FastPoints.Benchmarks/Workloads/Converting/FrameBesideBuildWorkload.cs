using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using FastPoints.Base;
using FastPoints.Convert;
using FastPoints.Files;
using FastPoints.LazEncoding;
using FastPoints.Partition;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Samplers;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>A conversion beside frames, as an editor runs it: all workers, and a tick of the pump a frame. Each frame has a
    /// few small jobs of its own and waits for them before it ends: how long, is the error. Its limit is the same conversion
    /// run to its end with as many workers.</summary>
    sealed class FrameBesideBuildWorkload : IWorkload
    {
        const int JobsPerFrame = 4;

        /// <summary>Seconds of each stage of the last run to the end of the same build.</summary>
        readonly Dictionary<string, double> m_toTheEnd;
        readonly bool m_isLaz;
        readonly Sampler m_sampler;
        readonly double m_frameMs;
        readonly double m_tickMs;
        string m_source;
        string m_target;
        NativeArray<uint> m_values;

        /// <param name="frameMs">0 to run to the end.</param>
        FrameBesideBuildWorkload(bool isLaz, Sampler sampler, double frameMs, double tickMs, Dictionary<string, double> toTheEnd)
            => (m_isLaz, m_sampler, m_frameMs, m_tickMs, m_toTheEnd) = (isLaz, sampler, frameMs, tickMs, toTheEnd);

        public static IEnumerable<IWorkload> All()
        {
            foreach (bool isLaz in new[] { false, true })
            {
                foreach (var sampler in new[] { Sampler.Random, Sampler.Poisson })
                {
                    var toTheEnd = new Dictionary<string, double>();
                    yield return new FrameBesideBuildWorkload(isLaz, sampler, 0, 0, toTheEnd);
                    yield return new FrameBesideBuildWorkload(isLaz, sampler, 1000.0 / 60, 2, toTheEnd);
                    // An editor without focus.
                    yield return new FrameBesideBuildWorkload(isLaz, sampler, 100, 4, toTheEnd);
                }
            }
        }

        public string Name => m_frameMs == 0 ? "no frame beside " + Build
            : string.Format(CultureInfo.InvariantCulture, "frame beside {0} at {1:0} Hz", Build, 1000 / m_frameMs);
        public string LimitName => m_frameMs == 0 ? null : "no frame beside " + Build;

        string Build => (m_isLaz ? "laz " : "las ") + m_sampler.ToString().ToLowerInvariant();

        public void Prepare(WorkloadContext context)
        {
            m_source = TerrainBenchmarkFile.Make(context);
            if (m_isLaz)
                m_source = Compressed(m_source);
            m_target = Path.Combine(context.ScratchFolder, Name + ".fastpoints");
            m_values = new NativeArray<uint>(JobsPerFrame, Allocator.Persistent);
        }

        static string Compressed(string las)
        {
            string laz = Path.ChangeExtension(las, ".laz");
            if (File.Exists(laz))
                return laz;
            using var stream = File.Create(laz);
            LazFile.Write(las, stream, new StageProgress(), default);
            return laz;
        }

        public WorkloadResult Run()
        {
            var progress = new StageProgress();
            ConvertResult result = null;
            var settings = new ConvertSettings
            {
                Sampler = m_sampler,
                Workers = Math.Max(1, JobsUtility.JobWorkerCount),
                AheadMs = m_frameMs > 50 ? 250 : 50,
                Attributes = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue },
            };
            using var reader = PointReaders.Open(m_source);
            var work = ConvertCloud.Run(new[] { reader }, m_target, settings, r => result = r, progress);
            var done = new WorkloadResult { Bytes = reader.Info.FileBytes };
            if (m_frameMs == 0)
                WorkPump.RunToEnd(work);
            else
                RunBeside(work, progress, ref done);
            foreach (var stage in progress.Finished)
                if (m_frameMs == 0)
                    m_toTheEnd[stage.Name] = stage.Seconds;
            done.Points = result.Manifest.Points;
            return done;
        }

        public void Dispose()
        {
            if (m_values.IsCreated)
                m_values.Dispose();
            if (Directory.Exists(m_target))
                Directory.Delete(m_target, true);
        }

        void RunBeside(IEnumerator<Work> work, StageProgress progress, ref WorkloadResult done)
        {
            using var waits = new SliceTimes(Allocator.Persistent);
            using var ticks = new SliceTimes(Allocator.Persistent);
            int frames = 0;
            var pump = new WorkPump(work);
            try
            {
                for (; !pump.IsDone; frames++)
                    RunFrame(pump, waits, ticks);
            }
            finally
            {
                pump.Cancel();
            }
            done.Error = waits.QuantileMs(0.99);
            done.ErrorUnit = "ms p99 wait";
            done.Note = string.Format(CultureInfo.InvariantCulture, "{0} frames waited for their own jobs {1:0.0} ms (p50), "
                + "{2:0.0} (p99), {3:0.0} (max), and for the pump {4:0.0}, {5:0.0}, {6:0.0}; stages took, and to the end:"
                + "{7}", frames, waits.QuantileMs(0.5), waits.QuantileMs(0.99), waits.QuantileMs(1), ticks.QuantileMs(0.5),
                ticks.QuantileMs(0.99), ticks.QuantileMs(1), Shares(progress));
        }

        string Shares(StageProgress progress) => string.Concat(progress.Finished.Where(s => m_toTheEnd.ContainsKey(s.Name))
            .Select(s => string.Format(CultureInfo.InvariantCulture, " {0} {1:0} of {2:0} ms,", s.Name, 1000 * s.Seconds,
                1000 * m_toTheEnd[s.Name]))).TrimEnd(',');

        void RunFrame(WorkPump pump, SliceTimes waits, SliceTimes ticks)
        {
            var watch = Stopwatch.StartNew();
            var own = new SmallJob { Values = m_values }.Schedule(JobsPerFrame, 1);
            JobHandle.ScheduleBatchedJobs();
            long begin = SliceTimes.Begin();
            pump.Tick(m_tickMs);
            ticks.End(begin);
            begin = SliceTimes.Begin();
            own.Complete();
            waits.End(begin);
            int left = (int)(m_frameMs - watch.Elapsed.TotalMilliseconds);
            if (left > 0 && !pump.IsDone)
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
