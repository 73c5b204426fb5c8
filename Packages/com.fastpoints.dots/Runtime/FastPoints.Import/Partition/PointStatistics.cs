using FastPoints.Points;

namespace FastPoints.Partition
{
    /// <summary>What the points of one slot showed, of those that are kept. Blittable.</summary>
    internal struct PointStatistics
    {
        public long Count;

        /// <summary>Without a finite place on the grid.</summary>
        public long LeftOut;
        public Grid3 Min;
        public Grid3 Max;

        /// <summary>Sum of the record hashes.</summary>
        public ulong Checksum;

        /// <summary>Largest distance of a float position from its place on the grid, in steps.</summary>
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

    /// <summary>What all values of one attribute showed. Blittable.</summary>
    internal struct AttributeStatistics
    {
        /// <summary>Smallest and largest as <see cref="Store.OrderedBits"/>.</summary>
        public ulong Min;
        public ulong Max;

        /// <summary>All values or-ed: trailing zeros are a power of two that divides every one.</summary>
        public ulong Or;

        /// <summary>0 where every value is a multiple of 257: eight bits twice.</summary>
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
