using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Chooses which part of a cloud to look at if all of them, far apart, would cover a few pixels together.
    static class LargestCluster
    {
        // The whole is at least this many times as long as the part: a few hundredths of a picture of all.
        const double FarInSizes = 25;
        const double MinGap = 1.0 / 16; // As a share of the whole length.
        const int MinPoints = 100;
        const int MaxSplits = 16;

        // Points are evenly chosen, in the file's order. Of equal parts the first in the file; all points if none is far off.
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

        // The largest of the parts between wide gaps along an axis, or null if these are not small.
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
