using Unity.Burst.Intrinsics;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Points around a cell, in units of its edge from its middle, and their squared distances from one of them. Eight
    /// are worked on at once, with or without AVX2 in the same order: the results are the same.</summary>
    internal unsafe struct Neighbourhood
    {
        public const int MaxPoints = 1024;
        const int Lanes = 8;
        const int Sums = 9;

        public const int ScratchFloats = 4 * MaxPoints;

        [NativeDisableUnsafePtrRestriction] readonly float* m_x;

        public Neighbourhood(float* scratch)
        {
            m_x = scratch;
            Count = 0;
        }

        public int Count { get; private set; }

        public readonly int Room => MaxPoints - Count;

        float* Y => m_x + MaxPoints;
        float* Z => m_x + 2 * MaxPoints;
        float* DistancesSq => m_x + 3 * MaxPoints;

        public void Clear() => Count = 0;
        public readonly float* End => m_x + Count; // Where the X of more go; Y and Z are MaxPoints further each.

        public void Add(int count) => Count += count;

        /// <summary>Fills the last eight up with points at infinity, which are not counted.</summary>
        public void Pad()
        {
            for (int i = Count; i % Lanes != 0; i++)
                m_x[i] = Y[i] = Z[i] = float.PositiveInfinity;
        }

        public void MeasureFrom(float3 q)
        {
            float* x = m_x, y = Y, z = Z, to = DistancesSq;
            if (X86.Avx2.IsAvx2Supported)
            {
                v256 qx = X86.Avx.mm256_set1_ps(q.x), qy = X86.Avx.mm256_set1_ps(q.y), qz = X86.Avx.mm256_set1_ps(q.z);
                for (int i = 0; i < Count; i += Lanes)
                {
                    var dx = X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(x + i), qx);
                    var dy = X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(y + i), qy);
                    var dz = X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(z + i), qz);
                    X86.Avx.mm256_storeu_ps(to + i, X86.Avx.mm256_add_ps(X86.Avx.mm256_add_ps(X86.Avx.mm256_mul_ps(dx, dx),
                        X86.Avx.mm256_mul_ps(dy, dy)), X86.Avx.mm256_mul_ps(dz, dz)));
                }
                return;
            }
            for (int i = 0; i < (Count + Lanes - 1) / Lanes * Lanes; i++)
            {
                float dx = x[i] - q.x, dy = y[i] - q.y, dz = z[i] - q.z;
                to[i] = dx * dx + dy * dy + dz * dz;
            }
        }

        /// <summary>How many are nearer; floats that are not negative are in the order of their bits.</summary>
        public int CountBelow(int limit)
        {
            var bits = (int*)DistancesSq;
            int count = 0;
            if (X86.Avx2.IsAvx2Supported)
            {
                var limits = X86.Avx.mm256_set1_epi32(limit);
                for (int i = 0; i < Count; i += Lanes)
                    count += math.countbits((uint)X86.Avx2.mm256_movemask_epi8(
                        X86.Avx2.mm256_cmpgt_epi32(limits, X86.Avx.mm256_loadu_si256(bits + i))));
                return count / 4;
            }
            for (int i = 0; i < Count; i++)
                count += bits[i] < limit ? 1 : 0;
            return count;
        }

        /// <summary>A limit below which so many squared distances are, or more if the next are equal.</summary>
        /// <param name="wanted">At most as many as there are.</param>
        /// <param name="limit">A guess; receives the limit, as bits of a float.</param>
        public int FindLimit(int wanted, ref int limit)
        {
            int low = 0, high = 0x7F800000, belowLow = 0, belowHigh = Count;
            for (int step = 0; high - low > 1; step++)
            {
                limit = math.clamp(limit, low + 1, high - 1);
                int below = CountBelow(limit);
                if (below == wanted)
                    return below;
                if (below < wanted)
                    (low, belowLow) = (limit, below);
                else
                    (high, belowHigh) = (limit, below);
                float from = math.asfloat((uint)low), to = math.asfloat((uint)high);
                // On a surface as many lie within a squared distance as it is large; where that leads nowhere, halves do.
                limit = step >= 8 ? low + (high - low) / 2
                    : float.IsInfinity(to) ? (int)math.asuint(math.max(from, 1e-12f) * (wanted + 0.5f) / math.max(0.5f, belowLow))
                    : (int)math.asuint(from + (to - from) * ((wanted + 0.5f - belowLow) / (belowHigh + 0.5f - belowLow)));
            }
            limit = high;
            return belowHigh;
        }

        /// <summary>Makes room: drops all that are not among the nearest, and of very many equal ones half.</summary>
        public void KeepNearest(float3 q, int wanted, ref int limit)
        {
            Pad();
            MeasureFrom(q);
            FindLimit(math.min(wanted, Count), ref limit);
            int kept = 0;
            for (int i = 0; i < Count && kept < MaxPoints / 2; i++)
            {
                if (((int*)DistancesSq)[i] >= limit)
                    continue;
                m_x[kept] = m_x[i];
                Y[kept] = Y[i];
                Z[kept++] = Z[i];
            }
            Count = kept;
        }

        public OffsetSums Sum(float3 q, int limit, int count)
        {
            float* sums = stackalloc float[Sums * Lanes];
            SumLanes(q, limit, sums);
            return Total(sums, count);
        }

        internal static OffsetSums Total(float* lanes, int count) => new OffsetSums
        {
            Count = count,
            Offset = new float3(TotalOf(lanes, 0), TotalOf(lanes, 1), TotalOf(lanes, 2)),
            Squares = new float3(TotalOf(lanes, 3), TotalOf(lanes, 4), TotalOf(lanes, 5)),
            Mixed = new float3(TotalOf(lanes, 6), TotalOf(lanes, 7), TotalOf(lanes, 8)),
        };

        void SumLanes(float3 q, int limit, float* sums)
        {
            if (X86.Avx2.IsAvx2Supported)
            {
                v256 qx = X86.Avx.mm256_set1_ps(q.x), qy = X86.Avx.mm256_set1_ps(q.y), qz = X86.Avx.mm256_set1_ps(q.z);
                var limits = X86.Avx.mm256_set1_epi32(limit);
                v256 x = X86.Avx.mm256_set1_ps(0), y = x, z = x, xx = x, yy = x, zz = x, xy = x, xz = x, yz = x;
                for (int i = 0; i < Count; i += Lanes)
                {
                    var isNear = X86.Avx2.mm256_cmpgt_epi32(limits, X86.Avx.mm256_loadu_si256(DistancesSq + i));
                    var dx = X86.Avx.mm256_and_ps(isNear, X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(m_x + i), qx));
                    var dy = X86.Avx.mm256_and_ps(isNear, X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(Y + i), qy));
                    var dz = X86.Avx.mm256_and_ps(isNear, X86.Avx.mm256_sub_ps(X86.Avx.mm256_loadu_ps(Z + i), qz));
                    x = X86.Avx.mm256_add_ps(x, dx);
                    y = X86.Avx.mm256_add_ps(y, dy);
                    z = X86.Avx.mm256_add_ps(z, dz);
                    xx = X86.Avx.mm256_add_ps(xx, X86.Avx.mm256_mul_ps(dx, dx));
                    yy = X86.Avx.mm256_add_ps(yy, X86.Avx.mm256_mul_ps(dy, dy));
                    zz = X86.Avx.mm256_add_ps(zz, X86.Avx.mm256_mul_ps(dz, dz));
                    xy = X86.Avx.mm256_add_ps(xy, X86.Avx.mm256_mul_ps(dx, dy));
                    xz = X86.Avx.mm256_add_ps(xz, X86.Avx.mm256_mul_ps(dx, dz));
                    yz = X86.Avx.mm256_add_ps(yz, X86.Avx.mm256_mul_ps(dy, dz));
                }
                X86.Avx.mm256_storeu_ps(sums, x);
                X86.Avx.mm256_storeu_ps(sums + Lanes, y);
                X86.Avx.mm256_storeu_ps(sums + 2 * Lanes, z);
                X86.Avx.mm256_storeu_ps(sums + 3 * Lanes, xx);
                X86.Avx.mm256_storeu_ps(sums + 4 * Lanes, yy);
                X86.Avx.mm256_storeu_ps(sums + 5 * Lanes, zz);
                X86.Avx.mm256_storeu_ps(sums + 6 * Lanes, xy);
                X86.Avx.mm256_storeu_ps(sums + 7 * Lanes, xz);
                X86.Avx.mm256_storeu_ps(sums + 8 * Lanes, yz);
                return;
            }
            SumLanesPlain(q, limit, sums);
        }

        internal void SumLanesPlain(float3 q, int limit, float* sums)
        {
            UnsafeUtility.MemClear(sums, Sums * Lanes * sizeof(float));
            for (int i = 0; i < Count; i++)
            {
                if (((int*)DistancesSq)[i] >= limit)
                    continue;
                float dx = m_x[i] - q.x, dy = Y[i] - q.y, dz = Z[i] - q.z;
                float* lane = sums + i % Lanes;
                lane[0] += dx;
                lane[Lanes] += dy;
                lane[2 * Lanes] += dz;
                lane[3 * Lanes] += dx * dx;
                lane[4 * Lanes] += dy * dy;
                lane[5 * Lanes] += dz * dz;
                lane[6 * Lanes] += dx * dy;
                lane[7 * Lanes] += dx * dz;
                lane[8 * Lanes] += dy * dz;
            }
        }

        static float TotalOf(float* lanes, int number)
        {
            float* s = lanes + number * Lanes;
            return s[0] + s[1] + (s[2] + s[3]) + (s[4] + s[5] + (s[6] + s[7]));
        }
    }
}
