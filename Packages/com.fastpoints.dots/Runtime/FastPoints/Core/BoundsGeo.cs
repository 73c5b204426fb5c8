using Unity.Mathematics;

namespace FastPoints
{
    /// <summary>An axis-aligned box in CRS units. Empty when any minimum exceeds its maximum.</summary>
    public struct BoundsGeo
    {
        public double3 Min;
        public double3 Max;

        public static BoundsGeo Empty => new BoundsGeo
        {
            Min = new double3(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
            Max = new double3(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity),
        };

        public BoundsGeo(double3 min, double3 max) => (Min, Max) = (min, max);

        public bool IsEmpty => !math.all(Min <= Max);

        public bool IsFinite => math.all(math.isfinite(Min)) && math.all(math.isfinite(Max));

        /// <summary>Zero on every axis for an empty box.</summary>
        public double3 Size => IsEmpty ? new double3(0, 0, 0) : Max - Min;

        /// <summary>Both ends are halved before they are added, so that the largest doubles do not overflow.</summary>
        public double3 Center => IsEmpty ? new double3(0, 0, 0) : Min * 0.5 + Max * 0.5;

        public void Include(double3 point)
        {
            Min = math.min(Min, point);
            Max = math.max(Max, point);
        }

        public void Include(BoundsGeo other)
        {
            Min = math.min(Min, other.Min);
            Max = math.max(Max, other.Max);
        }

        public bool Contains(double3 point) => math.all(point >= Min) && math.all(point <= Max);
    }
}
