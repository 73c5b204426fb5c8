using Unity.Mathematics;

namespace FastPoints.Picking
{
    /// <summary>
    /// What a pointer on a screen points along, in world space and in double: a ray with a width. It hits the points that are no
    /// farther from it than <see cref="RadiusAt"/> where they are nearest to it. Blittable.
    /// </summary>
    public struct PickRay
    {
        public double3 OriginWorld;

        /// <summary>A unit vector.</summary>
        public double3 DirectionWorld;

        /// <summary>World units, at the origin.</summary>
        public double Radius;

        /// <summary>World units more for each unit along the ray.</summary>
        public double RadiusPerUnit;

        /// <summary>Distances along the ray, in world units, that hits lie between: a camera's clip planes, for
        /// example.</summary>
        public double From;
        public double To;

        /// <summary>Of a perspective camera.</summary>
        /// <param name="direction">Of any length.</param>
        /// <param name="scalePx">Pixels of one unit at a distance of one unit
        /// (<see cref="Streaming.StreamView.ScalePx"/>).</param>
        /// <param name="radiusPx">Above 0: a ray without width hits nothing.</param>
        public static PickRay FromEye(double3 eyeWorld, double3 direction, double scalePx, double radiusPx) => new PickRay
        {
            OriginWorld = eyeWorld,
            DirectionWorld = math.normalize(direction),
            RadiusPerUnit = radiusPx / scalePx,
            To = double.PositiveInfinity,
        };

        /// <summary>Of an orthographic camera.</summary>
        /// <param name="originWorld">Where the pixel's line crosses the camera's plane.</param>
        /// <param name="scalePx">Pixels of one unit.</param>
        public static PickRay Parallel(double3 originWorld, double3 direction, double scalePx, double radiusPx) => new PickRay
        {
            OriginWorld = originWorld,
            DirectionWorld = math.normalize(direction),
            Radius = radiusPx / scalePx,
            To = double.PositiveInfinity,
        };

        /// <summary>World units.</summary>
        public double RadiusAt(double distance) => Radius + RadiusPerUnit * distance;
    }
}
