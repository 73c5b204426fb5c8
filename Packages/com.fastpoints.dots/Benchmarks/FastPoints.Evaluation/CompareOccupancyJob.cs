using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    [BurstCompile]
    public struct CompareOccupancyJob : IJob
    {
        const int RegionShift = 9; // Blocks of a region: 8 x 8 x 8.

        [ReadOnly] public NativeArray<ulong> CellsOfCloud;
        [ReadOnly] public NativeArray<long> PointsOfCloud;
        [ReadOnly] public NativeArray<ulong> CellsOfSample;
        [ReadOnly] public NativeArray<long> PointsOfSample;
        public NativeReference<CellError> Error;

        public unsafe void Execute()
        {
            var error = new CellError();
            long bare64 = 0, bare128 = 0, bare256 = 0, bare512 = 0;
            long* cloudOfRegion = stackalloc long[ErrorGrid.Regions];
            long* sampleOfRegion = stackalloc long[ErrorGrid.Regions];
            for (int region = 0; region < ErrorGrid.Regions; region++)
                cloudOfRegion[region] = sampleOfRegion[region] = 0;
            for (int block = 0; block < ErrorGrid.Blocks; block++)
            {
                if (PointsOfCloud[block] == 0)
                    continue;
                bool isBare = true;
                for (int word = 8 * block; word < 8 * block + 8; word++)
                {
                    ulong cloud = CellsOfCloud[word];
                    if (cloud == 0)
                        continue;
                    ulong sample = CellsOfSample[word];
                    isBare &= (sample & cloud) == 0;
                    error.Occupied128++;
                    bare128 += (sample & cloud) == 0 ? 1 : 0;
                    ulong cloud256 = BytesSet(cloud);
                    error.Occupied256 += math.countbits(cloud256);
                    bare256 += math.countbits(cloud256 & ~BytesSet(sample));
                    error.Occupied512 += math.countbits(cloud);
                    bare512 += math.countbits(cloud & ~sample);
                }
                error.Occupied64++;
                bare64 += isBare ? 1 : 0;
                error.PointsOfCloud += PointsOfCloud[block];
                error.PointsOfSample += PointsOfSample[block];
                cloudOfRegion[block >> RegionShift] += PointsOfCloud[block];
                sampleOfRegion[block >> RegionShift] += PointsOfSample[block];
            }
            error.Uncovered64 = Share(bare64, error.Occupied64);
            error.Uncovered128 = Share(bare128, error.Occupied128);
            error.Uncovered256 = Share(bare256, error.Occupied256);
            error.Uncovered512 = Share(bare512, error.Occupied512);
            double taken = error.PointsOfCloud == 0 ? 0 : error.PointsOfSample / (double)error.PointsOfCloud;
            MeasureVariation(ref error, taken);
            MeasureBias(ref error, taken, cloudOfRegion, sampleOfRegion);
            Error.Value = error;
        }

        void MeasureVariation(ref CellError error, double taken)
        {
            double squares = 0, variances = 0;
            int blocks = 0;
            for (int block = 0; block < ErrorGrid.Blocks; block++)
            {
                long points = PointsOfCloud[block];
                if (points < CellError.MinPointsOfBlock)
                    continue;
                double deviation = PointsOfSample[block] / (points * taken) - 1;
                squares += deviation * deviation;
                variances += math.max(0, 1 - taken) / (points * taken);
                blocks++;
            }
            bool isKnown = blocks > 0 && taken > 0;
            error.Variation = isKnown ? math.sqrt(squares / blocks) : double.NaN;
            error.VariationByChance = isKnown ? math.sqrt(variances / blocks) : double.NaN;
        }

        static unsafe void MeasureBias(ref CellError error, double taken, long* cloudOfRegion, long* sampleOfRegion)
        {
            error.Bias = error.BiasByChance = double.NaN;
            if (!(taken > 0))
                return;
            double* sigmaOfRegion = stackalloc double[ErrorGrid.Regions];
            int regions = 0;
            double bias = 0;
            for (int region = 0; region < ErrorGrid.Regions; region++)
            {
                long points = cloudOfRegion[region];
                if (points == 0 || points * CellError.MinRegion < error.PointsOfCloud)
                    continue;
                double expected = points * taken;
                bias = math.max(bias, math.abs(sampleOfRegion[region] / expected - 1));
                // A region's own points are part of the whole that its share is taken against: all of them leave no chance.
                double rest = 1 - points / (double)error.PointsOfCloud;
                sigmaOfRegion[regions++] = math.sqrt(math.max(0, 1 - taken) * rest / expected);
            }
            error.Bias = bias;
            error.BiasByChance = ChanceDeviation.MedianOfLargest(sigmaOfRegion, regions);
        }

        static double Share(long part, int whole) => whole == 0 ? 0 : part / (double)whole;

        static ulong BytesSet(ulong bits)
        {
            bits |= bits >> 4;
            bits |= bits >> 2;
            bits |= bits >> 1;
            return bits & 0x0101010101010101UL;
        }
    }

    static class ChanceDeviation
    {
        const int Halvings = 60;
        const double MaxSigmas = 10;

        /// <summary>The x that the largest |deviation| stays below in one case of two: the product of P(|deviation| &lt; x) is
        /// 1/2.</summary>
        public static unsafe double MedianOfLargest(double* sigmas, int count)
        {
            double low = 0, high = 0;
            for (int i = 0; i < count; i++)
                high = math.max(high, MaxSigmas * sigmas[i]);
            for (int halving = 0; halving < Halvings && high > 0; halving++)
            {
                double middle = (low + high) / 2, product = 1;
                for (int i = 0; i < count; i++)
                    product *= sigmas[i] > 0 ? Within(middle / sigmas[i]) : 1;
                if (product < 0.5)
                    low = middle;
                else
                    high = middle;
            }
            return high;
        }

        /// <summary>Probability that a standard normal deviate lies within +- x: erf(x / sqrt 2), to 1.5e-7 (Abramowitz and
        /// Stegun, Handbook of Mathematical Functions, 7.1.26).</summary>
        static double Within(double x)
        {
            double z = x * 0.70710678118654752;
            double t = 1 / (1 + 0.3275911 * z);
            double series = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
            return 1 - series * math.exp(-z * z);
        }
    }
}
