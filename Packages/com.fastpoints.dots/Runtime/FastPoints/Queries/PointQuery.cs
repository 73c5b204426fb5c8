using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    /// <summary>Which points of a cloud are asked for, in world space: those that a ray with a width hits, or those in a sphere
    /// or a box. The nearest along the ray come first, else the nearest to the centre. What is not a number, or has no extent,
    /// holds nothing.</summary>
    public struct PointQuery
    {
        /// <summary>The ray's beginning, or the centre of a sphere or a box.</summary>
        public double3 OriginWorld;

        /// <summary>A unit vector.</summary>
        public double3 DirectionWorld;

        /// <summary>Radius of a sphere, or of a ray at its origin, in world units. A point on the surface is inside.</summary>
        public double Radius;

        /// <summary>World units that the radius gains for each unit along the ray.</summary>
        public double RadiusPerUnit;

        /// <summary>Hits lie between these distances along the ray in world units: a camera's clip planes, for example.</summary>
        public double From;
        public double To;
        internal double3x3 EdgesWorld;
        internal QueryShape Shape;
        internal ViewMask Mask;

        /// <summary>A ray of a perspective camera. The radius is more than 0, the scale pixels of a unit at a distance of
        /// 1.</summary>
        public static PointQuery FromEye(double3 eyeWorld, double3 direction, double scalePx, double radiusPx) => new PointQuery
        {
            OriginWorld = eyeWorld,
            DirectionWorld = math.normalize(direction),
            RadiusPerUnit = radiusPx / scalePx,
            To = double.PositiveInfinity,
        };

        /// <summary>The ray of an orthographic camera from where the pixel's line crosses the camera's plane.</summary>
        public static PointQuery Parallel(double3 originWorld, double3 direction, double scalePx, double radiusPx) =>
            Ray(originWorld, direction, radiusPx / scalePx);

        /// <summary>A ray that is as wide everywhere, in world units.</summary>
        public static PointQuery Ray(double3 originWorld, double3 direction, double radiusWorld) => new PointQuery
        {
            OriginWorld = originWorld,
            DirectionWorld = math.normalize(direction),
            Radius = radiusWorld,
            To = double.PositiveInfinity,
        };

        /// <summary>What lies below a position, highest first: its first point is the ground, or a roof. Y points up.</summary>
        public static PointQuery Below(double3 positionWorld, double radiusWorld) =>
            Ray(positionWorld, new double3(0, -1, 0), radiusWorld);

        /// <summary>The points of a sphere, from its centre on.</summary>
        public static PointQuery Sphere(double3 centerWorld, double radiusWorld) =>
            new PointQuery { OriginWorld = centerWorld, Radius = radiusWorld, Shape = QueryShape.Sphere };

        /// <summary>All points, from this position on: as many neighbours as there is room for.</summary>
        public static PointQuery Nearest(double3 positionWorld) => Sphere(positionWorld, double.PositiveInfinity);

        /// <summary>The points of a box, which may be rotated and sheared, from its centre on.</summary>
        /// <param name="edgesWorld">World vectors of its three edges.</param>
        public static PointQuery Box(double3 centerWorld, double3x3 edgesWorld) =>
            new PointQuery { OriginWorld = centerWorld, EdgesWorld = edgesWorld, Shape = QueryShape.Box };

        /// <summary>Radius of a ray at a distance, in world units.</summary>
        public readonly double RadiusAt(double distance) => Radius + RadiusPerUnit * distance;
    }

    internal enum QueryShape : byte
    {
        Ray,
        Sphere,
        Box,
    }
}
