using FastPoints.Points;

namespace FastPoints.Partition
{
    /// <summary>Statistics of the kept points of one slot. Blittable.</summary>
    internal struct PointStatistics
    {
        public long Count;

        /// <summary>Number of points without a finite position on the grid.</summary>
        public long LeftOut;
        public Grid3 Min;
        public Grid3 Max;

        /// <summary>Sum of the record hashes.</summary>
        public ulong Checksum;

        /// <summary>Largest distance of a float position from its grid position, in steps.</summary>
        public double WorstLossSteps;

        public static PointStatistics None => new PointStatistics
        {
            Min = new Grid3(long.MaxValue, long.MaxValue, long.MaxValue),
            Max = new Grid3(long.MinValue, long.MinValue, long.MinValue),
        };

        public void Include(in PointStatistics other)
        {
            Count += other.Count;
            LeftOut += other.LeftOut;
            Min = Grid3.Min(Min, other.Min);
            Max = Grid3.Max(Max, other.Max);
            Checksum += other.Checksum;
            WorstLossSteps = WorstLossSteps > other.WorstLossSteps ? WorstLossSteps : other.WorstLossSteps;
        }
    }

    /// <summary>Statistics of all values of one attribute. Blittable.</summary>
    internal struct AttributeStatistics
    {
        /// <summary>Smallest and largest as <see cref="Store.OrderedBits"/>.</summary>
        public ulong Min;
        public ulong Max;

        /// <summary>The bitwise or of all values: trailing zeros give a power of two that divides all of them.</summary>
        public ulong Or;

        /// <summary>0 if every value is a multiple of 257: eight bits twice.</summary>
        public uint NotDoubled;

        public static AttributeStatistics None => new AttributeStatistics { Min = ulong.MaxValue };

        public bool IsEmpty => Min > Max;

        public void Include(in AttributeStatistics other)
        {
            Min = Min < other.Min ? Min : other.Min;
            Max = Max > other.Max ? Max : other.Max;
            Or |= other.Or;
            NotDoubled |= other.NotDoubled;
        }
    }
}
