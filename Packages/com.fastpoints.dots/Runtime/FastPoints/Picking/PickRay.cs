using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Picking
{
    /// <summary>The ray of a pointer on a screen, in world space and in double, with a width. It hits the points that are no
    /// farther from it than <see cref="RadiusAt"/> at their nearest place on the ray. Blittable.</summary>
    public struct PickRay
    {
        public double3 OriginWorld;

        /// <summary>A unit vector.</summary>
        public double3 DirectionWorld;

        /// <summary>Radius at the origin in world units.</summary>
        public double Radius;

        /// <summary>World units that the radius gains for each unit along the ray.</summary>
        public double RadiusPerUnit;

        /// <summary>Hits lie between these distances along the ray in world units: a camera's clip planes, for example.</summary>
        public double From;
        public double To;
        internal ViewMask Mask;

        /// <summary>The ray of a perspective camera, with a width of more than 0. The scale is in pixels of one unit at a
        /// distance of one unit (<see cref="StreamView.ScalePx"/>), the direction of any length.</summary>
        public static PickRay FromEye(double3 eyeWorld, double3 direction, double scalePx, double radiusPx) => new PickRay
        {
            OriginWorld = eyeWorld,
            DirectionWorld = math.normalize(direction),
            RadiusPerUnit = radiusPx / scalePx,
            To = double.PositiveInfinity,
        };

        /// <summary>The ray of an orthographic camera from where the pixel's line crosses the camera's plane.</summary>
        public static PickRay Parallel(double3 originWorld, double3 direction, double scalePx, double radiusPx) => new PickRay
        {
            OriginWorld = originWorld,
            DirectionWorld = math.normalize(direction),
            Radius = radiusPx / scalePx,
            To = double.PositiveInfinity,
        };

        /// <summary>Radius at a distance, in world units.</summary>
        public double RadiusAt(double distance) => Radius + RadiusPerUnit * distance;
    }
}
