using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Which boxes of one tree a ray's points may lie in: QuerySpace.Intersects in floats, from where the ray passes the tree, and
    // with room for what these round away.
    internal readonly unsafe struct BoxTreeRay
    {
        const double Rounding = 4e-6; // Floats that are summed here lose less than this share of the largest.
        const double LargestInverse = 1e25; // In place of infinity, so that nothing becomes no number.
        const double LargestRadius = 1e20; // Likewise.

        public readonly double Base; // Distance from which the others count.
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

        public BoxTreeRay(in PointQuery ray, in RayLocal local, in BoxTree tree)
        {
            tree.GetBounds(out var middle, out var half);
            Base = math.dot(middle + tree.Corner, local.AlongAxes) + local.AlongCorner;
            var origin = local.Origin + local.Direction * Base - tree.Corner;
            var largest = math.abs(middle) + half + math.abs(origin);
            m_origin = (float3)origin;
            m_inverse = (float3)math.clamp(1 / local.Direction, -LargestInverse, LargestInverse);
            m_absInverse = math.abs(m_inverse);
            m_alongAxes = (float3)local.AlongAxes;
            m_absAlong = math.abs(m_alongAxes);
            m_reach = (float3)local.Reach;
            double radius = math.min(ray.RadiusAt(Base), LargestRadius);
            double3 slack = Rounding * (largest + math.abs(radius) * local.Reach);
            m_slack = (float3)slack;
            m_alongSlack = (float)math.dot(math.abs(local.AlongAxes), slack);
            m_radius = (float)radius;
            m_radiusPerUnit = (float)ray.RadiusPerUnit;
            m_near = (float)(ray.From - Base) - m_alongSlack;
            m_far = (float)(ray.To - Base) + m_alongSlack;
        }

        // One bit for each box that may hold a hit, none of which is nearer than the box's start, which counts from Base.
        public static int Intersect(BoxTreeRay* ray, EightBoxes* boxes, float* starts)
        {
            if (X86.Avx2.IsAvx2Supported)
            {
                v256 along = X86.Avx.mm256_set1_ps(0), extent = X86.Avx.mm256_set1_ps(ray->m_alongSlack);
                for (int axis = 0; axis < 3; axis++)
                {
                    var middle = X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(boxes->Middle + axis * EightBoxes.Count),
                        X86.Avx.mm256_set1_ps(((float*)&ray->m_origin)[axis]));
                    var half = X86.Avx.mm256_add_ps(X86.Avx.mm256_loadu_ps(boxes->Half + axis * EightBoxes.Count),
                        X86.Avx.mm256_set1_ps(((float*)&ray->m_slack)[axis]));
                    along = X86.Avx.mm256_add_ps(along,
                        X86.Avx.mm256_mul_ps(middle, X86.Avx.mm256_set1_ps(((float*)&ray->m_alongAxes)[axis])));
                    extent = X86.Avx.mm256_add_ps(extent,
                        X86.Avx.mm256_mul_ps(half, X86.Avx.mm256_set1_ps(((float*)&ray->m_absAlong)[axis])));
                }
                var start = X86.Avx.mm256_max_ps(X86.Avx.mm256_sub_ps(along, extent), X86.Avx.mm256_set1_ps(ray->m_near));
                var end = X86.Avx.mm256_min_ps(X86.Avx.mm256_add_ps(along, extent), X86.Avx.mm256_set1_ps(ray->m_far));
                var radius = X86.Avx.mm256_max_ps(X86.Avx.mm256_set1_ps(0), X86.Avx.mm256_add_ps(
                    X86.Avx.mm256_set1_ps(ray->m_radius),
                    X86.Avx.mm256_mul_ps(X86.Avx.mm256_set1_ps(ray->m_radiusPerUnit), ray->m_radiusPerUnit > 0 ? end : start)));
                for (int axis = 0; axis < 3; axis++)
                {
                    var middle = X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(boxes->Middle + axis * EightBoxes.Count),
                        X86.Avx.mm256_set1_ps(((float*)&ray->m_origin)[axis]));
                    var half = X86.Avx.mm256_add_ps(X86.Avx.mm256_loadu_ps(boxes->Half + axis * EightBoxes.Count),
                        X86.Avx.mm256_set1_ps(((float*)&ray->m_slack)[axis]));
                    var inverse = X86.Avx.mm256_set1_ps(((float*)&ray->m_inverse)[axis]);
                    var reach = X86.Avx.mm256_mul_ps(
                        X86.Avx.mm256_add_ps(half,
                            X86.Avx.mm256_mul_ps(radius, X86.Avx.mm256_set1_ps(((float*)&ray->m_reach)[axis]))),
                        X86.Avx.mm256_set1_ps(((float*)&ray->m_absInverse)[axis]));
                    middle = X86.Avx.mm256_mul_ps(middle, inverse);
                    start = X86.Avx.mm256_max_ps(start, X86.Avx.mm256_sub_ps(middle, reach));
                    end = X86.Avx.mm256_min_ps(end, X86.Avx.mm256_add_ps(middle, reach));
                }
                X86.Avx.mm256_storeu_ps(starts, start);
                return X86.Avx.mm256_movemask_ps(X86.Avx.mm256_sub_ps(end, start)) ^ 0xFF;
            }
            return IntersectPlain(ray, boxes, starts);
        }

        // The same without intrinsics.
        internal static int IntersectPlain(BoxTreeRay* ray, EightBoxes* boxes, float* starts)
        {
            int hits = 0;
            for (int box = 0; box < EightBoxes.Count; box++)
            {
                var middle = new float3(boxes->Middle[box], boxes->Middle[EightBoxes.Count + box],
                    boxes->Middle[2 * EightBoxes.Count + box]) - ray->m_origin;
                var half = new float3(boxes->Half[box], boxes->Half[EightBoxes.Count + box],
                    boxes->Half[2 * EightBoxes.Count + box]) + ray->m_slack;
                // The ray's origin here is at distance 0, and a step of its direction is one.
                float along = middle.x * ray->m_alongAxes.x + middle.y * ray->m_alongAxes.y + middle.z * ray->m_alongAxes.z;
                float extent = ray->m_alongSlack + half.x * ray->m_absAlong.x + half.y * ray->m_absAlong.y +
                    half.z * ray->m_absAlong.z;
                float start = math.max(along - extent, ray->m_near), end = math.min(along + extent, ray->m_far);
                float radius = math.max(0, ray->m_radius + ray->m_radiusPerUnit * (ray->m_radiusPerUnit > 0 ? end : start));
                var reach = (half + radius * ray->m_reach) * ray->m_absInverse;
                middle *= ray->m_inverse;
                start = math.max(start, math.cmax(middle - reach));
                end = math.min(end, math.cmin(middle + reach));
                starts[box] = start;
                hits |= start <= end ? 1 << box : 0;
            }
            return hits;
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
