using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>The largest of several independent normal deviations.</summary>
    static class ChanceDeviation
    {
        /// <summary>Halvings until a double has no more digits to find.</summary>
        const int Halvings = 60;

        /// <summary>Beyond so many standard deviations there is nothing.</summary>
        const double MostSigmas = 10;

        /// <summary>The x that the largest |deviation| stays below in one case of two: the product of P(|deviation| &lt; x) is
        /// 1/2.</summary>
        public static unsafe double MedianOfLargest(double* sigmas, int count)
        {
            double low = 0, high = 0;
            for (int i = 0; i < count; i++)
                high = math.max(high, MostSigmas * sigmas[i]);
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
