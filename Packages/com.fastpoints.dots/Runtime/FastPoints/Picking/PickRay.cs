using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Picking
{
    /// <summary>The ray of a pointer on a screen, in world space, with a width: it hits points within RadiusAt.</summary>
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

        /// <summary>A ray of a perspective camera. The radius is more than 0, the scale pixels of a unit at a distance of
        /// 1.</summary>
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
