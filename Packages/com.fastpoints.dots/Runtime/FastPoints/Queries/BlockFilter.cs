using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Leaves out most of a block's points that a ray misses, in floats and with room for what these round away.
    internal unsafe struct BlockFilter
    {
        const double Rounding = 1e-5; // Bound of the relative rounding error of the floats below.

        readonly PointQuery m_ray;
        readonly double3x3 m_toRay; // Two axes across the ray, and the one along it.
        readonly float3 m_x; // A step along each of the cloud's axes, so seen.
        readonly float3 m_y;
        readonly float3 m_z;
        readonly float m_radiusPerUnit;
        float3 m_corner; // Of the block, from the ray at its distance.
        float m_radius;
        float m_near;
        float m_far;

        public BlockFilter(in PointQuery query, in QuerySpace space, double3 step) : this()
        {
            IsUsed = query.Shape == QueryShape.Ray;
            m_ray = query;
            m_radiusPerUnit = (float)query.RadiusPerUnit;
            var along = query.DirectionWorld;
            var other = math.abs(along.x) < 0.6 ? new double3(1, 0, 0) : new double3(0, 1, 0);
            var across = math.normalize(math.cross(along, other));
            m_toRay = math.transpose(new double3x3(across, math.cross(along, across), along));
            m_x = (float3)math.mul(m_toRay, space.ToWorldVector(new double3(step.x, 0, 0)));
            m_y = (float3)math.mul(m_toRay, space.ToWorldVector(new double3(0, step.y, 0)));
            m_z = (float3)math.mul(m_toRay, space.ToWorldVector(new double3(0, 0, step.z)));
        }

        public bool IsUsed { get; }

        // A block whose smallest coordinates are here, and which extends so many steps; hits are no farther than the limit.
        public void Begin(double3 fromOrigin, float3 steps, double limit)
        {
            var corner = math.mul(m_toRay, fromOrigin);
            double size = math.abs(corner.x) + math.abs(corner.y) +
                math.csum(math.abs(m_x) * steps.x + math.abs(m_y) * steps.y + math.abs(m_z) * steps.z);
            double radius = m_ray.RadiusAt(corner.z), slack = Rounding * (size + math.abs(radius));
            m_corner = new float3((float)corner.x, (float)corner.y, 0);
            m_radius = (float)(radius + slack * (1 + math.abs(m_ray.RadiusPerUnit)));
            m_near = (float)(m_ray.From - corner.z - slack);
            m_far = (float)(math.min(m_ray.To, limit) - corner.z + slack);
        }

        // One bit for each of eight points, of which these are the steps from the block's smallest coordinates on each axis.
        public readonly int MayHold(uint* x, uint* y, uint* z)
        {
            if (X86.Avx2.IsAvx2Supported)
            {
                v256 across = X86.Avx.mm256_set1_ps(m_corner.x), above = X86.Avx.mm256_set1_ps(m_corner.y);
                var along = X86.Avx.mm256_set1_ps(0);
                for (int axis = 0; axis < 3; axis++)
                {
                    var step = axis == 0 ? m_x : axis == 1 ? m_y : m_z;
                    var steps = X86.Avx.mm256_cvtepi32_ps(X86.Avx.mm256_loadu_si256(axis == 0 ? x : axis == 1 ? y : z));
                    across = X86.Avx.mm256_add_ps(across, X86.Avx.mm256_mul_ps(steps, X86.Avx.mm256_set1_ps(step.x)));
                    above = X86.Avx.mm256_add_ps(above, X86.Avx.mm256_mul_ps(steps, X86.Avx.mm256_set1_ps(step.y)));
                    along = X86.Avx.mm256_add_ps(along, X86.Avx.mm256_mul_ps(steps, X86.Avx.mm256_set1_ps(step.z)));
                }
                var radius = X86.Avx.mm256_add_ps(X86.Avx.mm256_set1_ps(m_radius),
                    X86.Avx.mm256_mul_ps(X86.Avx.mm256_set1_ps(m_radiusPerUnit), along));
                var inside = X86.Avx.mm256_sub_ps(X86.Avx.mm256_mul_ps(radius, radius), X86.Avx.mm256_add_ps(
                    X86.Avx.mm256_mul_ps(across, across), X86.Avx.mm256_mul_ps(above, above)));
                int outside = X86.Avx.mm256_movemask_ps(inside) |
                    X86.Avx.mm256_movemask_ps(X86.Avx.mm256_sub_ps(X86.Avx.mm256_set1_ps(m_far), along)) |
                    X86.Avx.mm256_movemask_ps(X86.Avx.mm256_sub_ps(along, X86.Avx.mm256_set1_ps(m_near)));
                return outside ^ 0xFF;
            }
            return MayHoldPlain(x, y, z);
        }

        // The same without intrinsics: Burst vectorizes it on other processors.
        internal readonly int MayHoldPlain(uint* x, uint* y, uint* z)
        {
            int hits = 0;
            for (int i = 0; i < EightBoxes.Count; i++)
            {
                float across = m_corner.x + m_x.x * x[i] + m_y.x * y[i] + m_z.x * z[i];
                float above = m_corner.y + m_x.y * x[i] + m_y.y * y[i] + m_z.y * z[i];
                float along = m_x.z * x[i] + m_y.z * y[i] + m_z.z * z[i];
                float radius = m_radius + m_radiusPerUnit * along;
                bool isIn = across * across + above * above <= radius * radius & along <= m_far & along >= m_near;
                hits |= isIn ? 1 << i : 0;
            }
            return hits;
        }
    }
}
