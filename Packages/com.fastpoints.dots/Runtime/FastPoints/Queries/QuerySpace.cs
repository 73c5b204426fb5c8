using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // A query relative to one cloud, which may be moved, rotated, scaled and sheared: lengths are in world units.
    internal struct QuerySpace
    {
        const double Slack = 1e-14; // Boxes are enlarged by this share of their coordinates, so that rounding loses no point.

        // Of world coordinates: a box holds its faces, and what rounding alone puts outside is on them.
        const double Rounding = 4.5e-16;
        const double RightAngle = 1e-12; // Axes whose cosines are smaller are at right angles.

        PointQuery m_query;
        double3x3 m_linear;
        double3 m_fromOrigin; // In the world, from the query's origin to the corner of the cloud's root cube.
        RayLocal m_local;
        double3 m_inverseDirection;
        readonly double m_alongSlack;
        double3 m_axisWorld; // World lengths of the cloud's axes if they are at right angles; otherwise 0.

        // From the world, relative to the centre, into the box of the query: inside, no coordinate is farther than a half from 0.
        double3x3 m_toBox;
        double3x3 m_localToBox;
        double3 m_halfBox;

        public QuerySpace(in PointQuery query, in CloudPlacement placement) : this()
        {
            m_query = query;
            m_linear = placement.Linear;
            m_fromOrigin = placement.OriginWorld - query.OriginWorld;
            var inverse = math.inverse(placement.Linear);
            var rows = math.transpose(inverse);
            m_local = new RayLocal
            {
                Origin = math.mul(inverse, -m_fromOrigin),
                Direction = math.mul(inverse, query.DirectionWorld),
                Reach = new double3(math.length(rows.c0), math.length(rows.c1), math.length(rows.c2)),
                AlongAxes = math.mul(math.transpose(m_linear), query.DirectionWorld),
                AlongCorner = math.dot(m_fromOrigin, query.DirectionWorld),
            };
            m_inverseDirection = 1 / m_local.Direction;
            m_alongSlack = Slack * math.csum(math.abs(m_fromOrigin));
            double x = math.length(m_linear.c0), y = math.length(m_linear.c1), z = math.length(m_linear.c2);
            bool isRight = math.abs(math.dot(m_linear.c0, m_linear.c1)) <= RightAngle * x * y &&
                math.abs(math.dot(m_linear.c0, m_linear.c2)) <= RightAngle * x * z &&
                math.abs(math.dot(m_linear.c1, m_linear.c2)) <= RightAngle * y * z;
            m_axisWorld = isRight ? new double3(x, y, z) * (1 - 4 * RightAngle) : 0;
            if (query.Shape != QueryShape.Box)
                return;
            m_toBox = math.inverse(query.EdgesWorld);
            m_localToBox = math.mul(m_toBox, m_linear);
            m_halfBox = 0.5 + Reach(m_toBox, Rounding * (math.abs(query.OriginWorld) + math.abs(m_fromOrigin)));
        }

        public readonly bool IsRay => m_query.Shape == QueryShape.Ray;

        public readonly BoxTreeRay RayFor(in BoxTree tree) => new BoxTreeRay(m_query, m_local, tree);

        // From CRS units from the corner of the root cube to the world, relative to the query's origin.
        public readonly double3 RelativeToOrigin(double3 local) => math.mul(m_linear, local) + m_fromOrigin;

        // The same for a difference of places.
        public readonly double3 ToWorldVector(double3 local) => math.mul(m_linear, local);

        // The position is in the space of FromOrigin. Distance is along the ray, or from the centre.
        public readonly bool Holds(double3 fromOrigin, out double distance, out double rayDistanceSq)
        {
            rayDistanceSq = 0;
            if (m_query.Shape != QueryShape.Ray)
            {
                distance = math.length(fromOrigin);
                return m_query.Shape == QueryShape.Sphere ? distance <= m_query.Radius
                    : math.all(math.abs(math.mul(m_toBox, fromOrigin)) <= m_halfBox);
            }
            distance = math.dot(fromOrigin, m_query.DirectionWorld);
            // Pythagoras would lose half of the digits in the difference of two squares.
            rayDistanceSq = math.lengthsq(fromOrigin - distance * m_query.DirectionWorld);
            double radius = m_query.RadiusAt(distance);
            return distance >= m_query.From && distance <= m_query.To && radius >= 0 && rayDistanceSq <= radius * radius;
        }

        // It may be true for a box without hits; no hit in it is nearer than distance. CRS units from the root's corner.
        public readonly bool Intersects(double3 center, double3 half, out double distance)
        {
            if (m_query.Shape == QueryShape.Ray)
                return IntersectsRay(center, half, out distance);
            distance = DistanceTo(center, half);
            if (m_query.Shape == QueryShape.Sphere)
                return distance <= m_query.Radius;
            var from = RelativeToOrigin(center);
            var at = math.abs(math.mul(m_toBox, from));
            var reach = Reach(m_localToBox, half) + Reach(m_toBox, Slack * (math.abs(from) + math.abs(m_fromOrigin)));
            return math.all(at - reach <= m_halfBox);
        }

        readonly bool IntersectsRay(double3 center, double3 half, out double distance)
        {
            double along = math.dot(center, m_local.AlongAxes) + m_local.AlongCorner;
            double extent = math.dot(math.abs(m_local.AlongAxes), half + Slack * math.abs(center)) + m_alongSlack;
            distance = math.max(m_query.From, along - extent);
            double end = math.min(m_query.To, along + extent);
            if (!(distance <= end))
                return false;
            // A hit's foot on the ray is no farther from it than the largest radius: the slabs are thicker by that much.
            var from = center - m_local.Origin;
            var reach = half + math.max(0, math.max(m_query.RadiusAt(distance), m_query.RadiusAt(end))) * m_local.Reach +
                Slack * (math.abs(center) + math.abs(m_local.Origin));
            return Clip(from.x, reach.x, m_inverseDirection.x, ref distance, ref end) &&
                Clip(from.y, reach.y, m_inverseDirection.y, ref distance, ref end) &&
                Clip(from.z, reach.z, m_inverseDirection.z, ref distance, ref end);
        }

        // At most that of the box's nearest position.
        readonly double DistanceTo(double3 center, double3 half)
        {
            var slack = Slack * (math.abs(center) + math.abs(m_local.Origin));
            var outside = math.max(0, math.abs(center - m_local.Origin) - half - slack);
            return m_axisWorld.x > 0 ? math.length(outside * m_axisWorld) : math.cmax(outside / m_local.Reach);
        }

        static double3 Reach(in double3x3 toBox, double3 half) =>
            math.abs(toBox.c0) * half.x + math.abs(toBox.c1) * half.y + math.abs(toBox.c2) * half.z;

        static bool Clip(double from, double reach, double inverse, ref double start, ref double end)
        {
            if (double.IsInfinity(inverse))
                return math.abs(from) <= reach;
            double a = (from - reach) * inverse, b = (from + reach) * inverse;
            start = math.max(start, math.min(a, b));
            end = math.min(end, math.max(a, b));
            return start <= end;
        }
    }
}
