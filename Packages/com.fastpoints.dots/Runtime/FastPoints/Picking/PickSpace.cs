using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Picking
{
    // A ray relative to one cloud, which may be moved, rotated, scaled and sheared: lengths are in world units.
    internal struct PickSpace
    {
        // Boxes are enlarged by this share of their coordinates, so that rounding loses no point.
        const double Slack = 1e-14;

        PickRay m_ray;
        double3x3 m_linear;
        double3 m_fromOrigin; // In the world, from the ray's origin to the corner of the cloud's root cube.
        double3 m_originLocal;
        double3 m_directionLocal;

        // How far a ball of radius 1 in the world reaches along each of the cloud's axes.
        double3 m_reachLocal;

        public PickSpace(in PickRay ray, in CloudPlacement placement)
        {
            m_ray = ray;
            m_linear = placement.Linear;
            m_fromOrigin = placement.OriginWorld - ray.OriginWorld;
            var inverse = math.inverse(placement.Linear);
            m_originLocal = math.mul(inverse, -m_fromOrigin);
            m_directionLocal = math.mul(inverse, ray.DirectionWorld);
            var rows = math.transpose(inverse);
            m_reachLocal = new double3(math.length(rows.c0), math.length(rows.c1), math.length(rows.c2));
        }

        // From CRS units from the corner of the root cube to the world, relative to the ray's origin.
        public double3 FromRay(double3 local) => math.mul(m_linear, local) + m_fromOrigin;

        // The same for a difference of places.
        public double3 Rotate(double3 local) => math.mul(m_linear, local);

        // The position is in the space of FromRay.
        public bool IntersectsPoint(double3 fromRay, out double distance, out double rayDistanceSq)
        {
            distance = math.dot(fromRay, m_ray.DirectionWorld);
            // Pythagoras would lose half of the digits in the difference of two squares.
            rayDistanceSq = math.lengthsq(fromRay - distance * m_ray.DirectionWorld);
            double radius = m_ray.RadiusAt(distance);
            return distance >= m_ray.From && distance <= m_ray.To && radius >= 0 && rayDistanceSq <= radius * radius;
        }

        // It may be true for a box without hits; no hit in it is nearer than distance. CRS units from the root's corner.
        public bool IntersectsBox(double3 center, double3 half, out double distance)
        {
            var direction = m_ray.DirectionWorld;
            var at = FromRay(center);
            double along = math.dot(at, direction);
            double extent = math.abs(math.dot(m_linear.c0, direction)) * half.x +
                math.abs(math.dot(m_linear.c1, direction)) * half.y + math.abs(math.dot(m_linear.c2, direction)) * half.z +
                Slack * math.csum(math.abs(at) + math.abs(m_fromOrigin));
            distance = math.max(m_ray.From, along - extent);
            double end = math.min(m_ray.To, along + extent);
            if (!(distance <= end))
                return false;
            // A hit's foot on the ray is no farther from it than the largest radius: the slabs are thicker by that much.
            var from = center - m_originLocal;
            var reach = half + math.max(0, m_ray.RadiusAt(end)) * m_reachLocal +
                Slack * (math.abs(center) + math.abs(m_originLocal));
            return Clip(from.x, reach.x, m_directionLocal.x, ref distance, ref end) &&
                Clip(from.y, reach.y, m_directionLocal.y, ref distance, ref end) &&
                Clip(from.z, reach.z, m_directionLocal.z, ref distance, ref end);
        }

        static bool Clip(double from, double reach, double direction, ref double start, ref double end)
        {
            if (direction == 0)
                return math.abs(from) <= reach;
            double a = (from - reach) / direction, b = (from + reach) / direction;
            start = math.max(start, math.min(a, b));
            end = math.min(end, math.max(a, b));
            return start <= end;
        }
    }
}
