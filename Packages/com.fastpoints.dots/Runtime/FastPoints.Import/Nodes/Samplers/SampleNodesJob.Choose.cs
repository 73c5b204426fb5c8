using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Stage = FastPoints.Nodes.SampleScratch.Stage;

namespace FastPoints.Nodes
{
    /// <summary>How points are chosen at one spacing: by cells, or by darts.</summary>
    internal unsafe partial struct SampleNodesJob
    {
        /// <summary>Bits 31 to 62: the point's priority; 0 to 30: its inverted index, so that of equal priorities the first on
        /// the curve is the best.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        long RankOf(int point) => (long)m_priority[point] << 31 | (uint)(int.MaxValue - point);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static int PointOf(long rank) => int.MaxValue - (int)(rank & int.MaxValue);

        void ChooseCells()
        {
            ref var range = ref Scratch.Ranges.ElementAt(m_state.Range);
            int* offered = Scratch.Offered.GetUnsafePtr();
            byte* offeredCommon = Scratch.OfferedCommon.GetUnsafePtr();
            int cellLog2 = m_state.CellLog2, last = range.First + m_state.Taken - 1;
            int commonOfCell = last < range.First ? 0 : offeredCommon[last];
            long best = m_state.Best;
            while (m_state.Child < range.FirstChild + range.ChildCount && m_budget > 0)
            {
                var child = Scratch.Ranges[m_state.Child];
                int first = child.First, end = Spend(m_state.Candidate, child.OfferedCount, CostOfCandidate);
                for (int k = first + m_state.Candidate; k < first + end; k++)
                {
                    int point = child.OffersAll ? k : offered[k], common = child.OffersAll ? m_common[k] : offeredCommon[k];
                    int newMask = cellLog2 - common >> 31;
                    last -= newMask;
                    best &= ~(long)newMask;
                    long rank = RankOf(point), betterMask = best - rank >> 63;
                    best ^= (best ^ rank) & betterMask;
                    commonOfCell ^= (commonOfCell ^ common) & newMask;
                    offered[last] = PointOf(best);
                    offeredCommon[last] = (byte)commonOfCell;
                }
                m_state.Candidate = end;
                if (end < child.OfferedCount)
                    break;
                m_state.Child++;
                m_state.Candidate = 0;
            }
            m_state.Best = best;
            m_state.Taken = last + 1 - range.First;
            if (m_state.Child < range.FirstChild + range.ChildCount)
                return;
            EndRange(ref range);
        }

        void EndRange(ref SampledCube range)
        {
            if (!m_state.IsFixing)
            {
                range.Offered = m_state.Taken;
                int* offered = Scratch.Offered.GetUnsafePtr();
                for (int k = range.First; k < range.First + m_state.Taken; k++)
                    m_rangeOfPoint[offered[k]] = m_state.Range;
                m_budget -= (long)m_state.Taken * CostOfSurvey;
            }
            BeginRange(m_state.Range);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        Grid3 PositionAt(int point) => Layout.PositionOf(m_records + (long)point * Layout.StrideBytes) - Corner;

        DartGrid Grid => Scratch.Grid.For(m_state.CellLog2, Averaged.HasColumns);

        void Gather()
        {
            ref var range = ref Scratch.Ranges.ElementAt(m_state.Range);
            int endChild = m_state.IsFixing ? m_state.Range + 1 : range.FirstChild + range.ChildCount;
            var grid = Grid;
            int* offered = Scratch.Offered.GetUnsafePtr();
            while (m_state.Child < endChild)
            {
                var child = Scratch.Ranges[m_state.Child];
                int end = Spend(m_state.Candidate, child.OfferedCount, CostOfGather), dartCount = m_state.Darts;
                // Capacity for all that may follow.
                ReserveDarts(dartCount + end - m_state.Candidate);
                long strip = FaceStrip;
                ulong* darts = Scratch.Darts.GetUnsafePtr();
                int* points = Scratch.PointOfDart.GetUnsafePtr();
                for (; m_state.Candidate < end; m_state.Candidate++)
                {
                    int point = child.OffersAll ? child.First + m_state.Candidate : offered[child.First + m_state.Candidate];
                    if (m_rangeOfPoint[point] < 0 && !m_state.IsFixing)
                        continue;
                    var position = PositionAt(point);
                    var tile = grid.TileOf(position);
                    if (dartCount == 0)
                    {
                        m_state.Tile = tile;
                    }
                    else if ((tile.X ^ m_state.Tile.X | tile.Y ^ m_state.Tile.Y | tile.Z ^ m_state.Tile.Z) != 0)
                    {
                        m_state.Darts = dartCount;
                        m_budget += (long)(end - m_state.Candidate) * CostOfGather;
                        BeginThrows();
                        return;
                    }
                    int classOffset = IsAtFace(position, strip) ? PoissonPriority.Classes : 0;
                    darts[dartCount] = grid.DartOf(position, PoissonPriority.ClassOf(m_priority[point]) + classOffset);
                    points[dartCount++] = point;
                }
                m_state.Darts = dartCount;
                if (end < child.OfferedCount)
                    return;
                m_state.Child++;
                m_state.Candidate = 0;
                if (m_budget <= 0 && m_state.Child < endChild)
                    return;
            }
            if (m_state.Darts > 0)
                BeginThrows();
            else
                EndRange(ref range);
        }

        /// <summary>A chunk is sampled without those beside it: 1.5 % of a level's points would be too near to one across a
        /// face. So what is within half a spacing of a face is tried last, and taken only if no sample is near, and none is near
        /// to where it is when moved inward by 7/8 of the spacing: 0.1 %. A surface along a face keeps its points.</summary>
        long FaceStrip =>
            Tops.Length > 0 || m_state.CellLog2 + DartGrid.TileSpacingsLog2 > RootSideLog2 ? 0 : 1L << m_state.CellLog2 >> 1;

        bool IsAtFace(in Grid3 position, long strip)
        {
            ulong inner = (1UL << RootSideLog2) - 2 * (ulong)strip;
            return (ulong)(position.X - strip) >= inner | (ulong)(position.Y - strip) >= inner |
                (ulong)(position.Z - strip) >= inner;
        }

        Grid3 Inward(in Grid3 position) => new Grid3(Inward(position.X), Inward(position.Y), Inward(position.Z));

        long Inward(long at)
        {
            long strip = FaceStrip, step = 7 * strip / 4;
            return at < strip ? at + step : (1L << RootSideLog2) - at <= strip ? at - step : at;
        }

        void ReserveDarts(int count)
        {
            if (Scratch.Darts.Length >= count)
                return;
            count = math.max(count, 4096);
            Scratch.Darts.ResizeUninitialized(count);
            Scratch.PointOfDart.ResizeUninitialized(count);
            Scratch.Order.ResizeUninitialized(count);
        }

        /// <summary>Sorts the tile's darts by the class of their priority; those of one class follow the Morton curve.</summary>
        void BeginThrows()
        {
            int* next = stackalloc int[PoissonPriority.ClassesWithFaces + 1];
            UnsafeUtility.MemClear(next, (PoissonPriority.ClassesWithFaces + 1) * sizeof(int));
            ulong* darts = Scratch.Darts.GetUnsafePtr();
            int* order = Scratch.Order.GetUnsafePtr();
            for (int k = 0; k < m_state.Darts; k++)
                next[DartGrid.ClassOf(darts[k]) + 1]++;
            for (int c = 1; c <= PoissonPriority.ClassesWithFaces; c++)
                next[c] += next[c - 1];
            for (int k = 0; k < m_state.Darts; k++)
                order[next[DartGrid.ClassOf(darts[k])]++] = k;
            Grid.BeginTile(m_state.Tile);
            m_budget -= CostOfTile;
            m_state.Dart = 0;
            m_state.Stage = Stage.Throw;
        }

        void Throw()
        {
            var grid = Grid;
            ulong* darts = Scratch.Darts.GetUnsafePtr();
            int* order = Scratch.Order.GetUnsafePtr(), points = Scratch.PointOfDart.GetUnsafePtr();
            int end = Spend(m_state.Dart, m_state.Darts, CostOfDart), taken = m_state.Taken;
            int max = m_state.IsFixing ? int.MaxValue : Sizes.MaxPointsPerNode;
            for (int d = m_state.Dart; d < end && taken < max; d++)
            {
                int dart = order[d];
                if (!m_state.IsFixing && (grid.IsNear(darts[dart]) || DartGrid.ClassOf(darts[dart]) >= PoissonPriority.Classes &&
                    grid.IsNear(grid.DartOf(Inward(PositionAt(points[dart])), 0))))
                    continue;
                grid.Add(darts[dart], m_state.IsFixing ? -1 : points[dart]);
                darts[dart] |= DartGrid.TakenFlag;
                taken++;
            }
            m_state.Dart = end;
            m_state.Taken = taken;
            if (end < m_state.Darts)
                return;
            EndTile(points, darts);
        }

        /// <summary>Offers the taken points along the curve.</summary>
        void EndTile(int* points, ulong* darts)
        {
            Grid.EndTile(m_state.Tile);
            if (!m_state.IsFixing)
            {
                int count = 0;
                for (int k = 0; k < m_state.Darts; k++)
                    count += (int)(darts[k] >> 63);
                int* to = Scratch.Offered.GetUnsafePtr() + Scratch.Ranges[m_state.Range].First + m_state.Taken - count;
                for (int k = 0; k < m_state.Darts; k++)
                    if (darts[k] >= DartGrid.TakenFlag)
                        *to++ = points[k];
            }
            m_state.Darts = 0;
            m_state.Stage = Stage.Gather;
        }

        /// <summary>Begins the next range whose points are candidates of a wider spacing but not of this one, or ends
        /// after the last.</summary>
        void BeginExclusion(int previous)
        {
            var ranges = Scratch.Ranges.GetUnsafePtr();
            for (int number = previous + 1; number < Scratch.Ranges.Length && !IsRandom; number++)
            {
                if (!NeedsExclusion(ranges, number))
                    continue;
                m_state.Range = number;
                m_state.Candidate = 0;
                m_state.HasTile = false;
                m_state.Stage = Stage.Exclude;
                return;
            }
            BeginAverages(-1);
        }

        bool NeedsExclusion(SampledCube* ranges, int number)
        {
            ref var range = ref ranges[number];
            bool isSampled = range.Kind == SampledCubeKind.Sampled && range.CellLog2 >= m_state.CellLog2;
            if (isSampled || range.Kind == SampledCubeKind.Passed || range.Parent < 0 ||
                ranges[range.Parent].CellLog2 <= m_state.CellLog2 || IsFixed(ranges, number))
                return false;
            m_budget -= Scratch.Ranges.Length;
            for (int r = 0; r < Scratch.Ranges.Length; r++)
                if (IsOfSpacing(ranges[r]) && AreWithinSpacing(range, ranges[r]))
                    return true;
            return false;
        }

        /// <summary>Whether the cubes of two ranges are no farther apart than the spacing.</summary>
        bool AreWithinSpacing(in SampledCube a, in SampledCube b)
        {
            long near = 1L << m_state.CellLog2, cornerMaskA = -1L << a.SideLog2, cornerMaskB = -1L << b.SideLog2;
            Grid3 p = PositionAt(a.First), q = PositionAt(b.First);
            return IsWithin((p.X & cornerMaskA) - (q.X & cornerMaskB), near, ~cornerMaskA, ~cornerMaskB) &&
                IsWithin((p.Y & cornerMaskA) - (q.Y & cornerMaskB), near, ~cornerMaskA, ~cornerMaskB) &&
                IsWithin((p.Z & cornerMaskA) - (q.Z & cornerMaskB), near, ~cornerMaskA, ~cornerMaskB);
        }

        static bool IsWithin(long apart, long near, long lastA, long lastB) => apart <= lastB + near && -apart <= lastA + near;

        /// <summary>Excludes from the nodes above each point that is nearer than this spacing to one of its samples: points of
        /// those nodes would otherwise be too near to points below.</summary>
        void ExcludePoints()
        {
            var range = Scratch.Ranges[m_state.Range];
            var grid = Grid;
            for (; m_state.Candidate < range.OfferedCount && m_budget > 0; m_state.Candidate++)
            {
                m_budget -= CostOfExclusion;
                int i = range.First + m_state.Candidate;
                i = range.OffersAll ? i : Scratch.Offered[i];
                var position = PositionAt(i);
                var tile = grid.TileOf(position);
                if (!m_state.HasTile || (tile.X ^ m_state.Tile.X | tile.Y ^ m_state.Tile.Y | tile.Z ^ m_state.Tile.Z) != 0)
                    m_state.IsEmpty = !grid.BeginTile(tile);
                m_state.Tile = tile;
                m_state.HasTile = true;
                if (!m_state.IsEmpty && m_rangeOfPoint[i] >= 0 && grid.IsNear(grid.DartOf(position, 0)))
                    m_rangeOfPoint[i] = ~m_state.Range;
            }
            if (m_state.Candidate == range.OfferedCount)
                BeginExclusion(m_state.Range);
        }
    }

    /// <summary>The order in which points are tried. Only the share of points with a higher priority matters, so priorities are
    /// classed by its magnitude: the exponent and two bits below it. Points of one class follow the Morton curve, which keeps the
    /// hash grid's neighbourhood in the cache; the classes before a class hold, on average, at least four times its
    /// points.</summary>
    internal static class PoissonPriority
    {
        const int Octaves = 16;

        public const int Classes = 4 * Octaves + 1;
        public const int ClassesWithFaces = 2 * Classes; // Twice as many: points beside the faces of their chunk come last.

        /// <summary>The class of a record's hash: 0 is tried first and has 2^-16 of the points.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int ClassOf(uint priority)
        {
            uint inverted = ~priority;
            int zeros = math.lzcnt(inverted);
            if (zeros >= Octaves)
                return 0;
            return (Octaves - 1 - zeros) * 4 + (int)(inverted >> (29 - zeros) & 3) + 1;
        }
    }
}
