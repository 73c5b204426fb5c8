using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>A slice of estimating normals: of a region's points in the order of the curve. Slices run side by side.</summary>
    /// <remarks>
    /// Points are taken cell by cell: the largest cells of the octree that have at most <see cref="PointsPerCell"/>. Neighbours
    /// come from the 27 cells around, each a range along the curve: at first from what is as near to the cell as the k-th is
    /// expected to be. Where that may be farther away, the point is taken again with all of them, then with cells twice as
    /// large, so that the neighbours are the nearest wherever cells are: but where 27 cells have more than 8,192 points, every
    /// second, third, ... of them.
    /// </remarks>
    [BurstCompile]
    internal unsafe struct EstimateNormalsJob : IJob
    {
        public const int PointsPerSlice = 6000; // A slice takes about 3 ms.

        const int PointsPerCell = 48;

        /// <summary>At first points are looked at that are so many times as far as the k-th neighbour is on average.</summary>
        const float MeanReaches = 1.35f;

        const int Cells = 27;
        const int MaxScanned = 1 << 13;

        public int First;
        public int End;
        public NormalRegion Region;
        [ReadOnly] public RegionPoints Points;

        /// <summary>Out, by point of the batch: those of others stay.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<ushort> Normals;

        [NativeDisableUnsafePtrRestriction] ulong* m_codes;
        [NativeDisableUnsafePtrRestriction] double* m_x;
        [NativeDisableUnsafePtrRestriction] double* m_y;
        [NativeDisableUnsafePtrRestriction] double* m_z;
        [NativeDisableUnsafePtrRestriction] int* m_firstOfBucket;
        Neighbourhood m_near;
        double3 m_min;
        double3 m_max;
        int m_count;
        int m_limit;

        /// <summary>Of the cells around the current one: where their points begin and end.</summary>
        [NativeDisableUnsafePtrRestriction] int* m_begins;
        [NativeDisableUnsafePtrRestriction] int* m_ends;
        int m_ranges;
        int m_total;

        public void Execute()
        {
            float* scratch = stackalloc float[Neighbourhood.ScratchFloats];
            int* pending = stackalloc int[PointsPerCell], begins = stackalloc int[Cells], ends = stackalloc int[Cells];
            m_begins = begins;
            m_ends = ends;
            m_near = new Neighbourhood(scratch);
            m_codes = (ulong*)Points.Codes.GetUnsafeReadOnlyPtr();
            m_x = (double*)Points.X.GetUnsafeReadOnlyPtr();
            m_y = (double*)Points.Y.GetUnsafeReadOnlyPtr();
            m_z = (double*)Points.Z.GetUnsafeReadOnlyPtr();
            m_firstOfBucket = (int*)Points.FirstOfBucket.GetUnsafeReadOnlyPtr();
            m_count = Points.Count.Value;
            m_min = Region.Min - Region.OuterMin;
            m_max = (Region.Max - Region.OuterMin) * Region.StepMetres;
            m_min *= Region.StepMetres;
            for (int i = FirstCell(); i < End;)
            {
                int level = LevelOf(i), shift = 3 * (Morton.BitsPerAxis - level), count = 0, end = i;
                // A finest cell may have any number, at one place or nearly so.
                for (; end < m_count && m_codes[end] >> shift == m_codes[i] >> shift && end - i < PointsPerCell; end++)
                    if (IsOwn(end))
                        pending[count++] = end;
                Estimate(pending, count, level);
                i = end;
            }
        }

        /// <summary>The first cell that begins in the slice: what the cells are does not depend on slices.</summary>
        int FirstCell()
        {
            if (First == 0)
                return 0;
            for (int level = 0; ; level++)
            {
                int shift = 3 * (Morton.BitsPerAxis - level), begin = First, end = First;
                ulong cell = m_codes[First] >> shift;
                while (begin > 0 && m_codes[begin - 1] >> shift == cell && First - begin <= PointsPerCell)
                    begin--;
                while (end < m_count && m_codes[end] >> shift == cell && end - begin <= PointsPerCell)
                    end++;
                if (end - begin <= PointsPerCell)
                    return begin == First ? First : end;
                if (level == Morton.BitsPerAxis)
                    return First;
            }
        }

        /// <summary>Of the cell that begins with a point: all larger ones have other points before it, or more than a
        /// cell may have.</summary>
        int LevelOf(int first)
        {
            int level = 0;
            if (first > 0)
                level = math.max(level, 1 + CommonLevels(m_codes[first], m_codes[first - 1]));
            if (first + PointsPerCell < m_count)
                level = math.max(level, 1 + CommonLevels(m_codes[first], m_codes[first + PointsPerCell]));
            return math.min(level, Morton.BitsPerAxis);
        }

        static int CommonLevels(ulong a, ulong b) => (math.lzcnt(a ^ b) - 1) / 3;

        double3 At(int p) => new double3(m_x[p], m_y[p], m_z[p]);

        bool IsOwn(int p)
        {
            var at = At(p);
            return math.all(at >= m_min) && math.all(at < m_max);
        }

        /// <summary>All points are in one cell of the level; those whose neighbours may be elsewhere are left for the next
        /// level up.</summary>
        void Estimate(int* pending, int count, int level)
        {
            for (; count > 0; level--)
            {
                int shift = Morton.BitsPerAxis - level;
                Morton.Decode(m_codes[pending[0]], out uint x, out uint y, out uint z);
                var cell = new uint3(x >> shift, y >> shift, z >> shift);
                double edge = Points.FinestCellMetres * (1L << shift);
                var middle = new double3(cell.x + 0.5, cell.y + 0.5, cell.z + 0.5) * edge;
                FindRanges(cell, level);
                // On a plane so near, if it cuts ten of the cells.
                float limit = 3.2f * (1 + Region.Neighbours) / m_total;
                m_limit = (int)math.asuint(limit);
                // First those that are little farther from the cell, then all around.
                for (float reach = math.min(1, MeanReaches * math.sqrt(limit)); ; reach = 1)
                {
                    bool isLast = reach == 1 && (level == 0 || m_total > MaxScanned);
                    count = Estimate(pending, count, middle, edge, reach, isLast);
                    if (reach == 1 || count == 0)
                        break;
                }
            }
        }

        int Estimate(int* pending, int count, double3 middle, double edge, float reach, bool isLast)
        {
            bool fits = TryCopy(middle, 1 / edge, 0.5f + reach, default, false);
            int left = 0;
            for (int i = 0; i < count; i++)
            {
                int p = pending[i];
                var q = (float3)((At(p) - middle) / edge);
                if (!fits)
                    TryCopy(middle, 1 / edge, 0.5f + reach, q, true);
                if (!TryEstimate(q, 0.5f + reach - math.cmax(math.abs(q)), isLast, out ushort normal))
                    pending[left++] = p;
                else
                    Normals[(int)Points.Ids[p]] = normal;
            }
            return left;
        }

        /// <param name="q">From the middle of the cell, in units of its edge.</param>
        /// <param name="known">All points so near have been copied.</param>
        bool TryEstimate(float3 q, float known, bool isLast, out ushort normal)
        {
            normal = OctahedralNormal.None;
            int wanted = 1 + Region.Neighbours;
            if (m_near.Count < wanted && !isLast)
                return false;
            m_near.MeasureFrom(q);
            int found = m_near.FindLimit(math.min(wanted, m_near.Count), ref m_limit);
            if (math.asfloat((uint)m_limit) > known * known && !isLast && !AreAllWithin(known, wanted))
                return false;
            if (!PlaneFit.TryFit(m_near.Sum(q, m_limit, found), out var direction))
                return true;
            // Of the two, the one that points up: viewers turn it round where they want to.
            normal = OctahedralNormal.Encode(direction.z < 0 ? -direction : direction);
            return true;
        }

        /// <summary>A limit may be beyond the last point below it.</summary>
        bool AreAllWithin(float distance, int wanted) => m_near.CountBelow((int)math.asuint(distance * distance)) >= wanted;

        void FindRanges(uint3 cell, int level)
        {
            int shift = 3 * (Morton.BitsPerAxis - level);
            uint last = (1u << level) - 1;
            m_ranges = m_total = 0;
            for (uint z = cell.z - math.min(cell.z, 1u); z <= math.min(cell.z + 1, last); z++)
                for (uint y = cell.y - math.min(cell.y, 1u); y <= math.min(cell.y + 1, last); y++)
                    for (uint x = cell.x - math.min(cell.x, 1u); x <= math.min(cell.x + 1, last); x++)
                    {
                        ulong code = Morton.Encode(x, y, z);
                        // One and the next along X are neighbours on the curve, too.
                        bool isPair = (x & 1) == 0 && x < math.min(cell.x + 1, last);
                        int begin = RegionPoints.FirstNotBelow(m_codes, m_firstOfBucket, code << shift);
                        int end = EndOf(begin, (isPair ? code + 2 : code + 1) << shift);
                        m_begins[m_ranges] = begin;
                        m_ends[m_ranges] = end;
                        m_total += end - begin;
                        m_ranges += end > begin ? 1 : 0;
                        x += isPair ? 1u : 0u;
                    }
        }

        /// <summary>Copies points of the cells around that are no farther from the middle, along any axis, than half.</summary>
        /// <returns>False if there is not room for all, unless those are wanted that are nearest to one.</returns>
        bool TryCopy(double3 middle, double scale, float half, float3 q, bool isForOne)
        {
            int step = 1 + (m_total - 1) / MaxScanned, skip = 0;
            uint limit = math.asuint(half) + 1;
            m_near.Clear();
            for (int r = 0; r < m_ranges; r++)
            {
                int p = m_begins[r] + skip;
                while (p < m_ends[r])
                {
                    if (m_near.Room == 0 && !isForOne)
                        return false;
                    if (m_near.Room == 0)
                        m_near.KeepNearest(q, 1 + Region.Neighbours, ref m_limit);
                    int count = math.min((m_ends[r] - p + step - 1) / step, m_near.Room), kept = 0;
                    float* x = m_near.End, y = x + Neighbourhood.MaxPoints, z = y + Neighbourhood.MaxPoints;
                    for (int i = 0; i < count; i++, p += step)
                    {
                        float dx = (float)((m_x[p] - middle.x) * scale), dy = (float)((m_y[p] - middle.y) * scale),
                            dz = (float)((m_z[p] - middle.z) * scale);
                        x[kept] = dx;
                        y[kept] = dy;
                        z[kept] = dz;
                        // Without a branch: all three differences are negative.
                        kept += (int)(((math.asuint(dx) & int.MaxValue) - limit & (math.asuint(dy) & int.MaxValue) - limit &
                            (math.asuint(dz) & int.MaxValue) - limit) >> 31);
                    }
                    m_near.Add(kept);
                }
                skip = p - m_ends[r];
            }
            m_near.Pad();
            return true;
        }

        int EndOf(int first, ulong code)
        {
            const int near = 24;
            int end = first;
            for (; end < m_count && end - first < near; end++)
                if (m_codes[end] >= code)
                    return end;
            return end < m_count ? RegionPoints.FirstNotBelow(m_codes, m_firstOfBucket, code) : m_count;
        }
    }
}
