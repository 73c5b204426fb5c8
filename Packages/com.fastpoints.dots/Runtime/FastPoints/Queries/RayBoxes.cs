using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Which boxes of one tree a ray's points may lie in: QuerySpace.Intersects in floats, from where the ray passes the tree, and
    // with room for what these round away.
    internal readonly struct RayBoxes
    {
        // Floats that are summed here lose less than this share of the largest.
        const double Rounding = 4e-6;

        // In place of infinity, so that nothing becomes no number.
        const double LargestInverse = 1e25;

        readonly double m_base; // Distance from which the others count.
        readonly float3 m_origin; // From the tree's corner, in CRS units.
        readonly float3 m_inverse;
        readonly float3 m_alongAxes;
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
            m_alongAxes = (float3)local.AlongAxes;
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

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool Intersects(in LocalBox box, out double distance)
        {
            float3 half = (box.Max - box.Min) * 0.5f + m_slack, from = (box.Max + box.Min) * 0.5f - m_origin;
            // The ray's origin here is at distance 0, and a step of its direction is one.
            float along = math.dot(from, m_alongAxes), extent = math.dot(math.abs(m_alongAxes), half) + m_alongSlack;
            float start = math.max(m_near, along - extent), end = math.min(m_far, along + extent);
            float radius = math.max(0, m_radius + math.max(m_radiusPerUnit * start, m_radiusPerUnit * end));
            float3 middle = from * m_inverse, reach = (half + radius * m_reach) * math.abs(m_inverse);
            start = math.max(start, math.cmax(middle - reach));
            distance = m_base + start;
            return start <= math.min(end, math.cmin(middle + reach));
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
