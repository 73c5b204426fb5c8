using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    [BurstCompile]
    internal struct MeasureSampleJob : IJob
    {
        public const int PointsPerSlice = 1 << 16;

        [ReadOnly] public NativeArray<double3> Stored;
        public int First;
        public int End;
        public NativeReference<SampleStatistics> Statistics; // The points so far; reset by the first slice.
        public SliceTimes SliceTimes;

        public static JobHandle Schedule(MeasureSampleJob job, JobHandle done)
        {
            do
            {
                job.First = job.End;
                job.End = math.min(job.Stored.Length, job.First + PointsPerSlice);
                done = job.Schedule(done);
            }
            while (job.End < job.Stored.Length);
            return done;
        }

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            var found = First > 0 ? Statistics.Value : new SampleStatistics
            {
                Min = new double3(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
                Max = new double3(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity),
                LowestDigit = new int3(int.MaxValue, int.MaxValue, int.MaxValue),
            };
            for (int i = First; i < End; i++)
            {
                var p = Stored[i];
                if (!math.all(math.isfinite(p)))
                    continue;
                found.Min = math.min(found.Min, p);
                found.Max = math.max(found.Max, p);
                found.LowestDigit = math.min(found.LowestDigit, new int3(LowestDigit(p.x), LowestDigit(p.y), LowestDigit(p.z)));
            }
            Statistics.Value = found;
            SliceTimes.End(begin);
        }

        static int LowestDigit(double value)
        {
            ulong bits = math.asulong(value);
            int exponent = (int)(bits >> 52 & 0x7FF);
            ulong mantissa = bits & (1UL << 52) - 1;
            if (exponent > 0)
                mantissa |= 1UL << 52;
            else
                exponent = 1;
            return mantissa == 0 ? int.MaxValue : exponent - 1075 + math.tzcnt(mantissa);
        }
    }

    internal struct SampleStatistics
    {
        public double3 Min; // Bounds of the finite ones; min exceeds max if there are none.
        public double3 Max;
        public int3 LowestDigit; // The lowest binary digit of any value, as a power of two; int.MaxValue if all are zero.
    }
}
