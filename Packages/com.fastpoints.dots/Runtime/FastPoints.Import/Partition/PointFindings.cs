using FastPoints.Points;

namespace FastPoints.Partition
{
    /// <summary>What the points of one slot showed, of those that are kept. Blittable.</summary>
    public struct PointFindings
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

        public static PointFindings None => new PointFindings
        {
            Min = new Grid3(long.MaxValue, long.MaxValue, long.MaxValue),
            Max = new Grid3(long.MinValue, long.MinValue, long.MinValue),
        };

        public void Include(in PointFindings other)
        {
            Count += other.Count;
            LeftOut += other.LeftOut;
            Min = Grid3.Min(Min, other.Min);
            Max = Grid3.Max(Max, other.Max);
            Checksum += other.Checksum;
            WorstLossSteps = WorstLossSteps > other.WorstLossSteps ? WorstLossSteps : other.WorstLossSteps;
        }
    }
}
