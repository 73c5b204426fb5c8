using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    // A view in one cloud's own space, where boxes are aligned with the axes. Planes stay exact under any affine transform.
    internal unsafe struct CloudView
    {
        public double3 Eye;
        public bool IsOrthographic;
        public bool IsShown;
        public bool IsLight;
        public int PlaneCount;
        public double ScalePx;

        // World length of a unit along each axis. If the transform shears, distances are those without shear.
        public double3 AxisScale;

        // World length of a unit of spacing: cells are as long as the octree's cubes along each axis, and the longest counts.
        public double SpacingScale;

        fixed double m_planes[StreamView.MaxFrustumPlanes * 4];

        /// <param name="cubeSize">Of the octree's root, in units of each axis.</param>
        public CloudView(in StreamView view, in CloudPlacement placement, double3 cubeSize)
        {
            var linear = placement.Linear;
            var fromEye = placement.OriginWorld - view.EyeWorld;
            Eye = math.mul(math.inverse(linear), -fromEye);
            IsOrthographic = view.IsOrthographic;
            IsLight = view.IsLight;
            IsShown = view.Mask.Shows(placement.Visibility);
            ScalePx = view.ScalePx;
            PlaneCount = view.PlaneCount;
            AxisScale = AxisScaleOf(placement);
            SpacingScale = SpacingScaleOf(AxisScale, cubeSize);
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

        public static double3 AxisScaleOf(in CloudPlacement placement) => new double3(math.length(placement.Linear.c0),
            math.length(placement.Linear.c1), math.length(placement.Linear.c2));

        // With degrees beside metres, cubes on the grid are no cubes in the world.
        public static double SpacingScaleOf(double3 axisScale, double3 cubeSize)
        {
            double longest = math.cmax(cubeSize);
            return longest > 0 ? math.cmax(axisScale * cubeSize) / longest : math.cmax(axisScale);
        }

        // It may be true for a box just outside an edge of the view.
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

        // 0 inside; 1 for an orthographic view.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double DistanceTo(double3 center, double3 half) =>
            IsOrthographic ? 1 : math.length(math.max(math.abs(Eye - center) - half, 0) * AxisScale);

        // Nearer than its own length something counts as ScalePx: nodes around a camera are ordered by their size.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double LengthPx(double lengthWorld, double distanceWorld) =>
            lengthWorld * ScalePx / (IsOrthographic ? 1 : math.max(distanceWorld, lengthWorld));
    }
}
