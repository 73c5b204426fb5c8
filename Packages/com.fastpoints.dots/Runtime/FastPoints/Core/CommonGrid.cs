using System;
using System.Collections.Generic;

namespace FastPoints
{
    // Finds one axis of the grid that several sources of whole numbers share: the finest scale, or a part of it, that divides
    // all scales and all distances between offsets.
    internal static class CommonGrid
    {
        // Positions farther out are left out, so that sums of positions and sides stay within a long.
        public const long Limit = 1L << 60;
        public const long InvalidPosition = long.MinValue;

        // Finds common steps of decimal scales: 0.01 and 0.025 meet at 0.005.
        static readonly int[] s_divisors =
        {
            1, 2, 4, 5, 8, 10, 16, 20, 25, 32, 40, 50, 64, 100, 125, 200, 250, 500, 1000, 10000, 100000, 1000000,
        };

        // Numbers of steps that differ by less count as equal: scales such as 0.01 are not binary fractions.
        const double ScaleTolerance = 1e-9;
        const double OffsetToleranceSteps = 1e-3;

        const long MaxFactor = 1L << 28;
        const double MaxShift = Limit / 2;

        // Counted from the first source's offset; the finest scale if they share none. Scales are not zero; signs are ignored.
        public static double StepOf(IReadOnlyList<double> scales, IReadOnlyList<double> offsets)
        {
            double finest = double.PositiveInfinity;
            for (int i = 0; i < scales.Count; i++)
                finest = Math.Min(finest, Math.Abs(scales[i]));
            foreach (int divisor in s_divisors)
            {
                double step = finest / divisor;
                bool fits = true;
                for (int i = 0; i < scales.Count && fits; i++)
                {
                    fits = IsWhole(scales[i] / step, ScaleTolerance) &&
                        IsWhole((offsets[i] - offsets[0]) / step, OffsetToleranceSteps);
                }
                if (fits)
                    return step;
            }
            return finest;
        }

        // grid = stored * factor + shift; false if the grid has no room. Loss: how far 32-bit numbers move, in CRS units.
        public static bool TryRescale(double scale, double offset, double step, double origin,
            out (long Factor, long Shift, double Loss) rescaled)
        {
            double exactFactor = scale / step, exactShift = (offset - origin) / step;
            rescaled = default;
            if (!(Math.Abs(exactFactor) < MaxFactor) || !(Math.Abs(exactShift) < MaxShift))
                return false;
            rescaled.Factor = (long)Math.Round(exactFactor);
            rescaled.Shift = (long)Math.Round(exactShift);
            if (!IsWhole(exactFactor, ScaleTolerance) || !IsWhole(exactShift, OffsetToleranceSteps))
                rescaled.Loss = step *
                    (Math.Abs(exactFactor - rescaled.Factor) * int.MaxValue + Math.Abs(exactShift - rescaled.Shift));
            return true;
        }

        static bool IsWhole(double value, double tolerance) =>
            Math.Abs(value - Math.Round(value)) <= tolerance * Math.Max(1, tolerance < 1e-6 ? Math.Abs(value) : 1);
    }
}
