using Unity.Mathematics;

namespace FastPoints.Points
{
    /// <summary>
    /// From the numbers that a file stores to georeferenced positions: geo = stored * <see cref="Scale"/> +
    /// <see cref="Offset"/>, in double, in CRS units. Identity for files that store coordinates as they are.
    /// </summary>
    public struct PositionTransform
    {
        public double3 Scale;
        public double3 Offset;

        public static PositionTransform Identity => new PositionTransform { Scale = new double3(1, 1, 1) };

        public double3 ToGeo(double3 stored) => stored * Scale + Offset;
    }
}
