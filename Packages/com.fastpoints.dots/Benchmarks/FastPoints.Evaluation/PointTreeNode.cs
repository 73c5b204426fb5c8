using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>The tight box of some points of a <see cref="PointTree"/>.</summary>
    public struct PointTreeNode
    {
        public double3 Min;
        public double3 Max;

        /// <summary>0 within the box.</summary>
        public readonly double DistanceSq(double3 point)
        {
            var outside = math.max(math.max(Min - point, point - Max), new double3(0, 0, 0));
            return math.dot(outside, outside);
        }
    }
}
