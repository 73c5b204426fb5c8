using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Core
{
    /// <summary>The smallest and largest finite value of a column, as doubles, and how many values were finite and how many were
    /// not.</summary>
    public struct ColumnRange
    {
        public double Min;
        public double Max;
        public long Finite;
        public long NonFinite;

        public static ColumnRange Empty => new ColumnRange { Min = double.PositiveInfinity, Max = double.NegativeInfinity };

        public bool IsEmpty => Finite == 0;

        public void Include(in ColumnRange other)
        {
            Min = math.min(Min, other.Min);
            Max = math.max(Max, other.Max);
            Finite += other.Finite;
            NonFinite += other.NonFinite;
        }

        /// <summary>The range of one column's values from <paramref name="first"/> on.</summary>
        public static unsafe ColumnRange Measure(byte* column, AttributeType type, int first, int count)
        {
            double* values = stackalloc double[ColumnValues.RunLength];
            var range = Empty;
            for (int done = 0; done < count; done += ColumnValues.RunLength)
            {
                int run = math.min(ColumnValues.RunLength, count - done);
                ColumnValues.ToDoubles(column, type, first + done, run, values);
                for (int i = 0; i < run; i++)
                {
                    double value = values[i];
                    if (value - value != 0)
                    {
                        range.NonFinite++;
                        continue;
                    }
                    range.Finite++;
                    range.Min = value < range.Min ? value : range.Min;
                    range.Max = value > range.Max ? value : range.Max;
                }
            }
            return range;
        }
    }
}
