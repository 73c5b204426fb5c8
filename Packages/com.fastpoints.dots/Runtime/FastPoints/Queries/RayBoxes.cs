using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Which boxes of one tree a ray's points may lie in: QuerySpace.Intersects in floats, from where the ray passes the tree, and
    // with room for what these round away.
    internal readonly struct RayBoxes
    {
        const double Rounding = 4e-6; // Floats that are summed here lose less than this share of the largest.
        const double LargestInverse = 1e25; // In place of infinity, so that nothing becomes no number.

        readonly double m_base; // Distance from which the others count.
        readonly float3 m_origin; // From the tree's corner, in CRS units.
        readonly float3 m_inverse;
        readonly float3 m_absInverse;
        readonly float3 m_alongAxes;
        readonly float3 m_absAlong;
        readonly float3 m_reach; // Of a world unit.
        readonly float3 m_slack;
        readonly float m_alongSlack;
        readonly float m_radius;
        readonly float m_radiusPerUnit;
        readonly float m_near;
        readonly float m_far;

        public RayBoxes(in PointQuery ray, in RayLocal local, double3 corner, in LocalBox all)
        {
            double3 min = all.Min, max = all.Max, center = (min + max) * 0.5 + corner;
            m_base = math.dot(center, local.AlongAxes) + local.AlongCorner;
            var origin = local.Origin + local.Direction * m_base - corner;
            var largest = math.max(math.abs(min), math.abs(max)) + math.abs(origin);
            m_origin = (float3)origin;
            m_inverse = (float3)math.clamp(1 / local.Direction, -LargestInverse, LargestInverse);
            m_absInverse = math.abs(m_inverse);
            m_alongAxes = (float3)local.AlongAxes;
            m_absAlong = math.abs(m_alongAxes);
            m_reach = (float3)local.Reach;
            double radius = ray.RadiusAt(m_base);
            double3 slack = Rounding * (largest + math.abs(radius) * local.Reach);
            m_slack = (float3)slack;
            m_alongSlack = (float)math.dot(math.abs(local.AlongAxes), slack);
            m_radius = (float)radius;
            m_radiusPerUnit = (float)ray.RadiusPerUnit;
            m_near = (float)(ray.From - m_base) - m_alongSlack;
            m_far = (float)(ray.To - m_base) + m_alongSlack;
        }

        // Axis by axis, which compilers without vectors of three make faster code of.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool Intersects(in LocalBox box, out double distance)
        {
            float halfX = (box.Max.x - box.Min.x) * 0.5f + m_slack.x, x = (box.Max.x + box.Min.x) * 0.5f - m_origin.x;
            float halfY = (box.Max.y - box.Min.y) * 0.5f + m_slack.y, y = (box.Max.y + box.Min.y) * 0.5f - m_origin.y;
            float halfZ = (box.Max.z - box.Min.z) * 0.5f + m_slack.z, z = (box.Max.z + box.Min.z) * 0.5f - m_origin.z;
            // The ray's origin here is at distance 0, and a step of its direction is one.
            float along = x * m_alongAxes.x + y * m_alongAxes.y + z * m_alongAxes.z;
            float extent = halfX * m_absAlong.x + halfY * m_absAlong.y + halfZ * m_absAlong.z + m_alongSlack;
            float start = along - extent, end = along + extent;
            start = start > m_near ? start : m_near;
            end = end < m_far ? end : m_far;
            distance = m_base + start;
            if (!(start <= end))
                return false;
            float radius = m_radius + m_radiusPerUnit * (m_radiusPerUnit > 0 ? end : start);
            radius = radius > 0 ? radius : 0;
            return Clip(x * m_inverse.x, (halfX + radius * m_reach.x) * m_absInverse.x, ref start, ref end) &&
                Clip(y * m_inverse.y, (halfY + radius * m_reach.y) * m_absInverse.y, ref start, ref end) &&
                Clip(z * m_inverse.z, (halfZ + radius * m_reach.z) * m_absInverse.z, ref start, ref end);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static bool Clip(float middle, float reach, ref float start, ref float end)
        {
            float low = middle - reach, high = middle + reach;
            start = low > start ? low : start;
            end = high < end ? high : end;
            return start <= end;
        }
    }

    // A ray in one cloud's space: CRS units from the corner of the root cube, for each world unit along it.
    internal struct RayLocal
    {
        public double3 Origin;
        public double3 Direction;
        public double3 Reach; // How far a ball of radius 1 in the world reaches along each axis.
        public double3 AlongAxes; // World units along the ray, of a unit along each axis.
        public double AlongCorner; // Distance of the corner.
    }
}
