using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Threading;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    public sealed class FrameLoop : IDisposable
    {
        const int JobsPerFrame = 4;

        readonly double m_tickMs;
        readonly int m_workersBefore = JobsUtility.JobWorkerCount;
        readonly SliceTimes m_waits = new SliceTimes(Allocator.Persistent);
        readonly SliceTimes m_ticks = new SliceTimes(Allocator.Persistent);
        NativeArray<uint> m_values = new NativeArray<uint>(JobsPerFrame, Allocator.Persistent);

        public FrameLoop(double tickMs, int workers)
        {
            m_tickMs = tickMs;
            JobsUtility.JobWorkerCount = workers;
        }

        public int Frames { get; private set; }

        /// <summary>What 99 of 100 frames did not wait longer for their own jobs than.</summary>
        public double WaitMs => m_waits.QuantileMs(0.99);

        public string Times => string.Format(CultureInfo.InvariantCulture, "{6} frames waited for their own jobs {0:0.0}, "
            + "{1:0.0}, {2:0.0} ms (p50, p99, max), and for the pump {3:0.00}, {4:0.0}, {5:0.0}", m_waits.QuantileMs(0.5), WaitMs,
            m_waits.QuantileMs(1), m_ticks.QuantileMs(0.5), m_ticks.QuantileMs(0.99), m_ticks.QuantileMs(1), Frames);

        /// <param name="frameMs">0 for a main thread that only steps the work; less than that for one that
        /// waits for jobs as well, and so runs some.</param>
        /// <returns>Its time in milliseconds.</returns>
        public double Run(IEnumerator<JobStep> work, double frameMs)
        {
            var all = Stopwatch.StartNew();
            if (frameMs < 0)
            {
                JobCoroutine.RunToEnd(work);
                return all.Elapsed.TotalMilliseconds;
            }
            var coroutine = new JobCoroutine(work);
            try
            {
                while (!coroutine.IsDone)
                    if (frameMs > 0)
                        RunFrame(coroutine, frameMs);
                    else if (!coroutine.Tick(1000))
                        Thread.Yield();
            }
            finally
            {
                coroutine.Cancel();
            }
            return all.Elapsed.TotalMilliseconds;
        }

        public void Dispose()
        {
            JobsUtility.JobWorkerCount = m_workersBefore;
            m_waits.Dispose();
            m_ticks.Dispose();
            m_values.Dispose();
        }

        void RunFrame(JobCoroutine coroutine, double frameMs)
        {
            Frames++;
            var frame = Stopwatch.StartNew();
            var own = new SmallJob { Values = m_values }.Schedule(JobsPerFrame, 1);
            JobHandle.ScheduleBatchedJobs();
            long begin = SliceTimes.Begin();
            coroutine.Tick(m_tickMs);
            m_ticks.End(begin);
            begin = SliceTimes.Begin();
            own.Complete();
            m_waits.End(begin);
            if (!coroutine.IsDone)
                Rest(frame, frameMs);
        }

        internal static void Rest(Stopwatch frame, double frameMs)
        {
            int left = (int)(frameMs - frame.Elapsed.TotalMilliseconds);
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
