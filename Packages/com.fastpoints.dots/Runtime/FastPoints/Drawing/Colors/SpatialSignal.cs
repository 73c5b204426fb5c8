using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Distinguishes values that depend on position from noise, and from values that are nearly all equal: whether they vary less
    // within cubes of space than throughout.
    sealed class SpatialSignal
    {
        // Points taken from a sample, spread over it: a few milliseconds of managed code.
        public const int MaxPoints = 16_384;
        const int Cubes = 24; // Along the longest edge.

        // Noise varies within cubes as much as throughout, give or take two hundredths; a dense forest is hardly better.
        const double MaxVarianceWithin = 0.9;
        const double MaxShareAlike = 0.75; // With more points of one value, what is left is outliers.
        const int MinPoints = 64;

        readonly BoundsGeo m_bounds;
        readonly double m_edge;
        readonly Dictionary<int, double3> m_cubes = new Dictionary<int, double3>();
        readonly Dictionary<double, int> m_values = new Dictionary<double, int>();

        public SpatialSignal(BoundsGeo bounds)
        {
            m_bounds = bounds;
            m_edge = math.max(math.cmax(bounds.Size) / Cubes, double.Epsilon);
        }

        public void Add(double3 position, double value)
        {
            var cube = math.min((position - m_bounds.Min) / m_edge, Cubes - 1);
            int at = ((int)cube.z * Cubes + (int)cube.y) * Cubes + (int)cube.x;
            m_cubes.TryGetValue(at, out var sums);
            m_cubes[at] = sums + new double3(1, value, value * value);
            m_values.TryGetValue(value, out int count);
            m_values[value] = count + 1;
        }

        public bool IsFound
        {
            get
            {
                int max = 0;
                foreach (int count in m_values.Values)
                    max = math.max(max, count);
                var all = new double3(0, 0, 0);
                double within = 0;
                foreach (var sums in m_cubes.Values)
                {
                    all += sums;
                    within += Squares(sums);
                }
                double freedom = all.x - m_cubes.Count;
                if (all.x < MinPoints || freedom < MinPoints)
                    return max < all.x;
                return max <= MaxShareAlike * all.x && within / freedom <= MaxVarianceWithin * Squares(all) / (all.x - 1);
            }
        }

        // Sum of squared differences from the mean.
        static double Squares(double3 sums) => math.max(0, sums.z - sums.y * sums.y / sums.x);
    }
}
