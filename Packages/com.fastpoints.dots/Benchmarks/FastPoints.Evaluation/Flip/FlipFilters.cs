using System;
using Unity.Collections;

namespace FastPoints.Evaluation
{
    /// <summary>The convolutions of FLIP, each a product of one along x and one along y. All are even or odd, so that weights are
    /// kept from the centre outwards, a tap of four after the other.</summary>
    internal struct FlipFilters : IDisposable
    {
        public const int Stride = 4;
        const double FeatureWidth = 0.082; // Width of the lines that the eye finds edges by, in degrees (the paper's w).

        // Contrast sensitivity as sums of Gaussians (the paper's table 1): amplitude and scale.
        const double ScaleOfY = 0.0047, ScaleOfCx = 0.0053;
        const double AmplitudeOfCz = 34.1, ScaleOfCz = 0.04, SecondAmplitudeOfCz = 13.5, SecondScaleOfCz = 0.025;

        /// <summary>By tap: of Y, of Cx, of the first and of the second Gaussian of Cz, of which each has its own pass.</summary>
        [ReadOnly] public NativeArray<float> Colors;

        /// <summary>By tap: a Gaussian, its first derivative (odd: as it is to the left), its second.</summary>
        [ReadOnly] public NativeArray<float> Features;

        public int ColorRadius;
        public int FeatureRadius;

        public FlipFilters(double pixelsPerDegree, Allocator allocator)
        {
            double widest = Math.Sqrt(ScaleOfCz / (2 * Math.PI * Math.PI));
            double deviation = 0.5 * FeatureWidth * pixelsPerDegree;
            ColorRadius = (int)Math.Ceiling(3 * widest * pixelsPerDegree);
            FeatureRadius = (int)Math.Ceiling(3 * deviation);
            Colors = new NativeArray<float>(Stride * (ColorRadius + 1), allocator);
            Features = new NativeArray<float>(Stride * (FeatureRadius + 1), allocator);
            SetColors(pixelsPerDegree);
            SetFeatures(deviation);
        }

        public int Radius => Math.Max(ColorRadius, FeatureRadius);

        public void Dispose()
        {
            Colors.Dispose();
            Features.Dispose();
        }

        // The weights of Y and of Cx add up to 1, those of the two Gaussians of Cz together, in both directions.
        void SetColors(double pixelsPerDegree)
        {
            double sumY = 0, sumCx = 0, sumFirst = 0, sumSecond = 0;
            for (int tap = -ColorRadius; tap <= ColorRadius; tap++)
            {
                double distanceSq = tap / pixelsPerDegree * (tap / pixelsPerDegree);
                sumY += Gaussian(distanceSq, ScaleOfY);
                sumCx += Gaussian(distanceSq, ScaleOfCx);
                sumFirst += RootAmplitude(AmplitudeOfCz, ScaleOfCz) * Gaussian(distanceSq, ScaleOfCz);
                sumSecond += RootAmplitude(SecondAmplitudeOfCz, SecondScaleOfCz) * Gaussian(distanceSq, SecondScaleOfCz);
            }
            double sumCz = Math.Sqrt(sumFirst * sumFirst + sumSecond * sumSecond);
            double first = RootAmplitude(AmplitudeOfCz, ScaleOfCz) / sumCz;
            double second = RootAmplitude(SecondAmplitudeOfCz, SecondScaleOfCz) / sumCz;
            for (int tap = 0; tap <= ColorRadius; tap++)
            {
                double distanceSq = tap / pixelsPerDegree * (tap / pixelsPerDegree);
                Colors[Stride * tap] = (float)(Gaussian(distanceSq, ScaleOfY) / sumY);
                Colors[Stride * tap + 1] = (float)(Gaussian(distanceSq, ScaleOfCx) / sumCx);
                Colors[Stride * tap + 2] = (float)(first * Gaussian(distanceSq, ScaleOfCz));
                Colors[Stride * tap + 3] = (float)(second * Gaussian(distanceSq, SecondScaleOfCz));
            }
        }

        // The positive weights of a derivative add up to 1, the negative ones to -1.
        void SetFeatures(double deviation)
        {
            double sum = 0, sumOfFirst = 0, sumOfPositive = 0, sumOfNegative = 0;
            for (int tap = -FeatureRadius; tap <= FeatureRadius; tap++)
            {
                double gaussian = Math.Exp(-tap * tap / (2 * deviation * deviation)), second = SecondOf(tap, deviation);
                sum += gaussian;
                sumOfFirst += tap < 0 ? -tap * gaussian : 0;
                sumOfPositive += Math.Max(0, second);
                sumOfNegative -= Math.Min(0, second);
            }
            for (int tap = 0; tap <= FeatureRadius; tap++)
            {
                double gaussian = Math.Exp(-tap * tap / (2 * deviation * deviation)), second = SecondOf(tap, deviation);
                Features[Stride * tap] = (float)(gaussian / sum);
                Features[Stride * tap + 1] = (float)(tap * gaussian / sumOfFirst);
                Features[Stride * tap + 2] = (float)(second / (second > 0 ? sumOfPositive : sumOfNegative));
            }
        }

        static double SecondOf(int tap, double deviation)
        {
            double squares = tap * tap / (deviation * deviation);
            return (squares - 1) * Math.Exp(-squares / 2);
        }

        static double Gaussian(double distanceSq, double scale) => Math.Exp(-Math.PI * Math.PI * distanceSq / scale);

        // Of one of the two passes.
        static double RootAmplitude(double amplitude, double scale) => Math.Sqrt(amplitude * Math.Sqrt(Math.PI / scale));
    }
}
