using System;
using Unity.Collections;
using Unity.Mathematics;
using Unity.Profiling.LowLevel.Unsafe;

namespace FastPoints
{
    // How long single runs of jobs took: Unity's queue has no priorities, so a run blocks its worker for everything else in the
    // frame. Jobs that follow one another share one.
    internal struct SliceTimes : IDisposable
    {
        const int Buckets = 8192; // One bucket is 0.1 ms; the last one has all longer runs.
        const long NanosecondsPerBucket = 100000;

        NativeArray<int> m_runsOfBucket;

        public SliceTimes(Allocator allocator) => m_runsOfBucket = new NativeArray<int>(Buckets, allocator);

        public static long Begin() => ProfilerUnsafeUtility.Timestamp;

        public void End(long begin)
        {
            var ratio = ProfilerUnsafeUtility.TimestampToNanosecondsConversionRatio;
            double nanoseconds = (ProfilerUnsafeUtility.Timestamp - begin) * (double)ratio.Numerator / ratio.Denominator;
            m_runsOfBucket[(int)math.clamp(nanoseconds / NanosecondsPerBucket, 0, Buckets - 1)]++;
        }

        public void TakeFrom(SliceTimes other)
        {
            var from = other.m_runsOfBucket;
            for (int i = 0; i < Buckets; i++)
            {
                m_runsOfBucket[i] += from[i];
                from[i] = 0;
            }
        }

        // 1 for the longest; 0 if nothing ran.
        public double QuantileMs(double share)
        {
            long all = 0;
            for (int i = 0; i < Buckets; i++)
                all += m_runsOfBucket[i];
            long wanted = Math.Max(1, (long)Math.Ceiling(all * share)), sum = 0;
            for (int i = 0; i < Buckets && all > 0; i++)
                if ((sum += m_runsOfBucket[i]) >= wanted)
                    return (i + 1) * (NanosecondsPerBucket / 1e6);
            return 0;
        }

        public void Dispose()
        {
            if (m_runsOfBucket.IsCreated)
                m_runsOfBucket.Dispose();
        }
    }
}
