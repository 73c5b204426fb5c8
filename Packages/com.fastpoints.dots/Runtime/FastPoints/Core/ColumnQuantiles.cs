using Unity.Mathematics;

namespace FastPoints.Core
{
    // The range of a column's finite values, and the values below which given shares of them lie. They come from at most 65,536
    // values taken at even distances: the share below each is right within 0.2 % of all values (4 sigma of a binomial at a
    // half), whatever the outliers.
    internal struct ColumnQuantiles
    {
        const int MaxSampledValues = 65536;

        public ColumnRange Range;

        // Values of the column itself (nearest rank); NaN if it has no finite value.
        public double Low;
        public double High;
        public double LowerQuartile;
        public double UpperQuartile;

        // Of a column of this length: the length of the scratch memory.
        public static int SampledValues(int count) => count == 0 ? 0 : (count - 1) / Step(count) + 1;

        static int Step(int count) => (count - 1) / MaxSampledValues + 1;

        public static ColumnQuantiles Empty => new ColumnQuantiles { Range = ColumnRange.Empty };

        public static unsafe ColumnQuantiles Measure(in ColumnRange stored, byte* column, AttributeType type, int count,
            double scale, double offset, double lowShare, double highShare, ulong* keys, ulong* keyScratch)
        {
            double a = stored.Min * scale + offset, b = stored.Max * scale + offset;
            var found = new ColumnQuantiles
            {
                Range = stored,
                Low = double.NaN,
                High = double.NaN,
                LowerQuartile = double.NaN,
                UpperQuartile = double.NaN
            };
            if (stored.IsEmpty)
                return found;
            found.Range.Min = math.min(a, b);
            found.Range.Max = math.max(a, b);

            int taken = 0;
            int step = Step(count);
            for (long i = 0; i < count; i += step)
            {
                double value = ColumnValues.ToDouble(column, type, (int)i) * scale + offset;
                if (value - value == 0)
                    keys[taken++] = ColumnValues.OrderedBits(value);
            }
            if (taken == 0)
            {
                found.Low = found.LowerQuartile = found.Range.Min;
                found.High = found.UpperQuartile = found.Range.Max;
                return found;
            }
            RadixSort.Sort(keys, null, keyScratch, null, taken);
            found.Low = ColumnValues.FromOrderedBits(keys[Rank(lowShare, taken)]);
            found.High = ColumnValues.FromOrderedBits(keys[Rank(highShare, taken)]);
            found.LowerQuartile = ColumnValues.FromOrderedBits(keys[Rank(0.25, taken)]);
            found.UpperQuartile = ColumnValues.FromOrderedBits(keys[Rank(0.75, taken)]);
            return found;
        }

        static int Rank(double share, int count) => (int)math.clamp(share * (count - 1) + 0.5, 0, count - 1);
    }
}
