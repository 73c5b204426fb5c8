using Unity.Mathematics;

namespace FastPoints.Records
{
    /// <summary>What a sampled point stands for. Blittable.</summary>
    public struct PointAverage
    {
        /// <summary>Points of the cloud, itself included.</summary>
        public double Points;

        /// <summary>Sums over them of up to four values: the columns of the averaged planes.</summary>
        public double4 Sum;
    }
}
