using Unity.Mathematics;

namespace FastPoints.Core
{
    /// <summary>The one grid that all points of a cloud lie on: geo = <see cref="Origin"/> + <see cref="Step"/> * grid, in
    /// double, in CRS units.</summary>
    public struct CloudGrid
    {
        public double3 Origin;

        /// <summary>Positive on each axis.</summary>
        public double3 Step;

        public double3 ToGeo(Grid3 place) => new double3(place.X, place.Y, place.Z) * Step + Origin;

        /// <summary>The same, for numbers that are stored as offsets from a corner of the grid.</summary>
        /// <remarks>Rounds once more than <see cref="ToGeo"/>: for pictures, not for proofs.</remarks>
        public PositionTransform FromCorner(Grid3 corner) => new PositionTransform { Scale = Step, Offset = ToGeo(corner) };
    }
}
