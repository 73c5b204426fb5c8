using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>Chooses which of a cloud's parts to look at if they lie so far apart that all of them together cover a few
    /// pixels.</summary>
    static class LargestPart
    {
        /// <summary>The whole is at least this many times as long as the part: each part is a few hundredths of a picture of
        /// all.</summary>
        const double FarInSizes = 25;

        /// <summary>The smallest gap between parts, as a share of the whole length.</summary>
        const double MinGap = 1.0 / 16;

        /// <summary>Fewer points do not make a part.</summary>
        const int MinPoints = 100;

        /// <summary>The deepest nesting of parts.</summary>
        const int MaxSplits = 16;

        /// <param name="points">Evenly chosen points, in the file's order.</param>
        /// <returns>The points of the part that has most of them (of equal parts, the first in the file); all points if no
        /// parts are far apart.</returns>
        public static double3[] Of(double3[] points)
        {
            for (int split = 0; split < MaxSplits; split++)
            {
                double3[] largest = null;
                for (int axis = 0; axis < 3 && largest == null && points.Length >= MinPoints; axis++)
                    largest = Split(points, axis);
                if (largest == null)
                    break;
                points = largest;
            }
            return points;
        }

        /// <summary>The largest of the parts between wide gaps along an axis, or null if these are not small.</summary>
        static double3[] Split(double3[] points, int axis)
        {
            var values = new double[points.Length];
            for (int i = 0; i < values.Length; i++)
                values[i] = points[i][axis];
            Array.Sort(values);
            double length = values[values.Length - 1] - values[0];
            var begins = new List<double> { values[0] };
            for (int i = 1; i < values.Length; i++)
                if (values[i] - values[i - 1] > length * MinGap)
                    begins.Add(values[i]);
            if (begins.Count == 1)
                return null;
            // Parts are in the order of their first points.
            var parts = new List<List<double3>>();
            var numbers = new int[begins.Count];
            foreach (var point in points)
            {
                int begin = begins.BinarySearch(point[axis]);
                begin = begin < 0 ? ~begin - 1 : begin;
                if (numbers[begin] == 0)
                {
                    parts.Add(new List<double3>());
                    numbers[begin] = parts.Count;
                }
                parts[numbers[begin] - 1].Add(point);
            }
            var largest = parts[0];
            foreach (var part in parts)
                largest = part.Count > largest.Count ? part : largest;
            double size = SizeOf(largest);
            return size > 0 && length >= FarInSizes * size ? largest.ToArray() : null;
        }

        /// <summary>The longest edge of the points' box.</summary>
        static double SizeOf(List<double3> points)
        {
            double3 min = points[0], max = points[0];
            foreach (var point in points)
            {
                min = math.min(min, point);
                max = math.max(max, point);
            }
            return math.cmax(max - min);
        }
    }
}
