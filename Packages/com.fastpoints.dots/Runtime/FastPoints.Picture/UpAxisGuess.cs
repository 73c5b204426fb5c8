using System;
using System.Globalization;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Guesses the up axis of formats that do not say it: across the plane that most points lie in, the ground or a floor. Without
    // one it is Y, as models have it, but where coordinates are a survey's.
    static class UpAxisGuess
    {
        const double Thickness = 1.0 / 32; // Of the longest edge.
        const double MinRatio = 1.5; // So many times as many points lie in it as in the best plane across another axis.

        // Models lie about their origin. What is so many times its own size away from it was surveyed.
        const double MinSizesFromOrigin = 100;

        // All formats but PLY have Z up, by their standards or by custom.
        public static bool Applies(string format) => format != null && format.StartsWith("PLY", StringComparison.Ordinal);

        // The positions are a fair sample, outliers apart; the reason is a line for people.
        public static UpAxis Of(double3[] positions, out string reason)
        {
            var shares = new double3();
            double longest = 0, farthest = 0;
            var values = new double[3][];
            for (int axis = 0; axis < 3; axis++)
            {
                values[axis] = new double[positions.Length];
                for (int i = 0; i < positions.Length; i++)
                    values[axis][i] = positions[i][axis];
                Array.Sort(values[axis]);
                if (positions.Length == 0)
                    continue;
                longest = math.max(longest, values[axis][positions.Length - 1] - values[axis][0]);
                farthest = math.max(farthest, math.abs(values[axis][positions.Length / 2]));
            }
            int best = 2;
            for (int axis = 0; axis < 3; axis++)
            {
                shares[axis] = MaxPointsWithin(values[axis], longest * Thickness) / (double)math.max(1, positions.Length);
                best = shares[axis] > shares[best] ? axis : best;
            }
            double other = math.max(shares[(best + 1) % 3], shares[(best + 2) % 3]);
            bool isClear = shares[best] > MinRatio * other;
            string share = (100 * shares[best]).ToString("0", CultureInfo.InvariantCulture) + " %";
            bool isModel = positions.Length > 0 && farthest <= MinSizesFromOrigin * longest;
            var up = isClear ? (UpAxis)best : isModel ? UpAxis.Y : UpAxis.Z;
            reason = up + " is taken for up: " + (isClear ? share + " of the points lie in one plane across it"
                : "no plane across an axis has most points, and this looks like a " + (isModel ? "model" : "survey"));
            return up;
        }

        static int MaxPointsWithin(double[] sorted, double length)
        {
            int max = 0;
            for (int first = 0, end = 0; first < sorted.Length; first++)
            {
                while (end < sorted.Length && sorted[end] - sorted[first] <= length)
                    end++;
                max = math.max(max, end - first);
            }
            return max;
        }
    }
}
