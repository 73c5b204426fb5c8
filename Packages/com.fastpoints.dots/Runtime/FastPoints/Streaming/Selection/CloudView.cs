using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>A <see cref="StreamView"/> in one cloud's own space, where boxes are aligned with the axes. Planes stay exact
    /// under any affine transform. Blittable, for jobs.</summary>
    internal unsafe struct CloudView
    {
        public double3 Eye;
        public bool IsOrthographic;

        /// <summary>Whether the view shows the cloud at all.</summary>
        public bool IsShown;
        public int PlaneCount;
        public double ScalePx;

        /// <summary>World length of a unit along each of the cloud's axes. If the transform shears, distances are those of the
        /// cloud without shear.</summary>
        public double3 AxisScale;
        public double LargestScale;

        fixed double m_planes[StreamView.MaxFrustumPlanes * 4];

        public CloudView(in StreamView view, in CloudPlacement placement)
        {
            var linear = placement.Linear;
            var fromEye = placement.OriginWorld - view.EyeWorld;
            Eye = math.mul(math.inverse(linear), -fromEye);
            IsOrthographic = view.IsOrthographic;
            IsShown = view.Mask.Shows(placement.Visibility);
            ScalePx = view.ScalePx;
            PlaneCount = view.PlaneCount;
            AxisScale = new double3(math.length(linear.c0), math.length(linear.c1), math.length(linear.c2));
            LargestScale = math.cmax(AxisScale);
            fixed (double4* worldPlanes = &view.Plane0)
            {
                for (int p = 0; p < view.PlaneCount; p++)
                {
                    var normal = worldPlanes[p].xyz;
                    m_planes[4 * p] = math.dot(linear.c0, normal);
                    m_planes[4 * p + 1] = math.dot(linear.c1, normal);
                    m_planes[4 * p + 2] = math.dot(linear.c2, normal);
                    m_planes[4 * p + 3] = math.dot(normal, fromEye) + worldPlanes[p].w;
                }
            }
        }

        /// <summary>Whether a box reaches inside every plane. It may be true for one just outside an edge of the view.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IntersectsFrustum(double3 center, double3 half)
        {
            if (!IsShown)
                return false;
            for (int p = 0; p < PlaneCount; p++)
            {
                double x = m_planes[4 * p], y = m_planes[4 * p + 1], z = m_planes[4 * p + 2];
                if (x * center.x + y * center.y + z * center.z + m_planes[4 * p + 3] +
                    math.abs(x) * half.x + math.abs(y) * half.y + math.abs(z) * half.z < 0)
                    return false;
            }
            return true;
        }

        /// <summary>World distance from the eye to a box, 0 inside; 1 for an orthographic view.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double DistanceTo(double3 center, double3 half) =>
            IsOrthographic ? 1 : math.length(math.max(math.abs(Eye - center) - half, 0) * AxisScale);

        /// <summary>Length on the screen of something at a distance. Nearer than its own length it counts as
        /// <see cref="ScalePx"/>: nodes around a camera are ordered by their size.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double LengthPx(double lengthWorld, double distanceWorld) =>
            lengthWorld * ScalePx / (IsOrthographic ? 1 : math.max(distanceWorld, lengthWorld));
    }
}
