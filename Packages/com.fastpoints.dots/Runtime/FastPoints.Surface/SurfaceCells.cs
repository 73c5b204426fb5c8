using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>A cell of which somebody may want the surface.</summary>
    internal sealed class SurfaceCell
    {
        public int3 At;
        public double Distance; // From the nearest place, in world units.
        public long NearInPlan, WantedInPlan; // The last plan that had it within the radius, and that wanted it.
        public int Triangles = -1; // Known once it was made, even if there was no room for it.
        public object Collider; // Of its owner's kind; null while it is not made, or if it is empty.
        public double RetryAt; // It failed, and is not tried before.
        public ulong Edits; // Where its triangles are known: the hash of the edits that reached its points.
        public bool IsStale; // Other edits reach them now. What was made stands until it is made anew.

        public bool IsMade => Triangles == 0 || Collider != null;
        public bool IsReady => IsMade && !(IsStale && Collider == null);
    }

    /// <summary>Which cells are wanted around places, the nearest first, within budgets. Those that were made stay until others
    /// need the room; what was wanted longest ago goes first.</summary>
    internal sealed class SurfaceCells
    {
        const int MaxReachCells = 8; // Nobody wants thousands of cells.

        static readonly Comparison<SurfaceCell> s_nearestFirst = (a, b) =>
            (a.Distance, a.At.z, a.At.y, a.At.x).CompareTo((b.Distance, b.At.z, b.At.y, b.At.x));

        readonly SurfaceGrid m_grid;
        readonly Action<SurfaceCell> m_free;
        readonly Dictionary<int3, SurfaceCell> m_cells = new Dictionary<int3, SurfaceCell>();
        readonly List<SurfaceCell> m_wanted = new List<SurfaceCell>(), m_forgotten = new List<SurfaceCell>();
        long m_plan;

        public int MaxCells = int.MaxValue;
        public long MaxTriangles = long.MaxValue;

        public SurfaceCells(in SurfaceGrid grid, Action<SurfaceCell> free) => (m_grid, m_free) = (grid, free);

        public List<SurfaceCell> Made { get; } = new List<SurfaceCell>(); // Cells that were made, empty ones too.
        public long Triangles { get; private set; }

        public int Version { get; private set; } // Another whenever a cell was made or given up.

        public SurfaceCell Busy; // Is being made, and not forgotten meanwhile.

        /// <summary>Plans anew, around places in metres along the source's axes from the root's corner.</summary>
        /// <param name="lengths">World units of a metre along these axes.</param>
        /// <param name="radius">In world units.</param>
        public void Plan(List<double3> places, double3 lengths, double radius)
        {
            m_plan++;
            m_wanted.Clear();
            foreach (var place in places)
                AddNear(place, lengths, radius);
            m_wanted.Sort(s_nearestFirst);
            int count = 0;
            for (long triangles = 0; count < m_wanted.Count; count++)
            {
                triangles += m_wanted[count].IsStale ? 0 : math.max(0, m_wanted[count].Triangles);
                // The nearest one is wanted whatever it takes.
                if (count > 0 && (count >= MaxCells || triangles > MaxTriangles))
                    break;
                m_wanted[count].WantedInPlan = m_plan;
            }
            m_wanted.RemoveRange(count, m_wanted.Count - count);
            // Nobody makes these anew.
            for (int i = Made.Count - 1; i >= 0; i--)
                if (Made[i].IsStale && Made[i].WantedInPlan != m_plan && Made[i] != Busy)
                    Drop(Made[i]);
            Trim();
            foreach (var cell in m_cells.Values)
                if (cell.NearInPlan != m_plan && !cell.IsMade && cell != Busy)
                    m_forgotten.Add(cell);
            foreach (var cell in m_forgotten)
                m_cells.Remove(cell.At);
            m_forgotten.Clear();
        }

        /// <summary>The nearest that is not made, or stale; null if none is, or they failed a moment ago.</summary>
        public SurfaceCell Next(double now)
        {
            foreach (var cell in m_wanted)
                if ((!cell.IsMade || cell.IsStale) && cell.RetryAt <= now)
                    return cell;
            return null;
        }

        public void SetMade(SurfaceCell cell, int triangles, ulong edits)
        {
            if (Made.Contains(cell))
                Triangles -= cell.Triangles;
            else
                Made.Add(cell);
            (cell.Triangles, cell.Edits, cell.IsStale, cell.RetryAt) = (triangles, edits, false, 0);
            Triangles += triangles;
            Version++;
            Trim();
        }

        /// <summary>Those whose triangles are known, made or not.</summary>
        public List<SurfaceCell> Known()
        {
            var known = new List<SurfaceCell>(m_cells.Values);
            known.RemoveAll(cell => cell.Triangles < 0);
            return known;
        }

        /// <summary>If other edits reach it than when it was made, it is to be made anew.</summary>
        public void SetEdits(SurfaceCell cell, ulong edits)
        {
            cell.IsStale = cell.IsMade && cell.Edits != edits;
            if (!cell.IsMade && cell.Edits != edits)
                cell.Triangles = -1;
        }

        /// <summary>Whether all cells so near to a place are made, or stand as they were.</summary>
        public bool IsReady(double3 place, double3 reach)
        {
            int3 first = m_grid.CellOf(place - reach), count = m_grid.CellOf(place + reach) - first + 1;
            for (int i = 0; i < count.x * count.y * count.z; i++)
                if (!m_cells.TryGetValue(first + At(i, count), out var cell) || !cell.IsReady)
                    return false;
            return true;
        }

        void AddNear(double3 place, double3 lengths, double radius)
        {
            var reach = math.min(radius / lengths, MaxReachCells * m_grid.CellMetres);
            int3 first = m_grid.CellOf(place - reach), count = m_grid.CellOf(place + reach) - first + 1;
            for (int i = 0; i < count.x * count.y * count.z; i++)
            {
                var at = first + At(i, count);
                var fromMiddle = math.abs(place / m_grid.CellMetres - new double3(at.x, at.y, at.z) - 0.5);
                double distance = math.length(lengths * math.max(0, fromMiddle - 0.5)) * m_grid.CellMetres;
                if (distance > radius)
                    continue;
                if (!m_cells.TryGetValue(at, out var cell))
                    m_cells.Add(at, cell = new SurfaceCell { At = at });
                if (cell.NearInPlan != m_plan)
                    m_wanted.Add(cell);
                cell.Distance = cell.NearInPlan == m_plan ? math.min(cell.Distance, distance) : distance;
                cell.NearInPlan = m_plan;
            }
        }

        static int3 At(int i, int3 count) => new int3(i % count.x, i / count.x % count.y, i / (count.x * count.y));

        void Trim()
        {
            while (Made.Count > 1 && (Made.Count > MaxCells || Triangles > MaxTriangles))
            {
                SurfaceCell oldest = null;
                foreach (var cell in Made)
                    if ((m_wanted.Count == 0 || cell != m_wanted[0]) && (oldest == null ||
                        (cell.WantedInPlan, -cell.Distance).CompareTo((oldest.WantedInPlan, -oldest.Distance)) < 0))
                        oldest = cell;
                Drop(oldest);
            }
        }

        void Drop(SurfaceCell cell)
        {
            Made.Remove(cell);
            Version++;
            Triangles -= cell.Triangles;
            if (cell.Collider != null)
                m_free(cell);
            if (cell.Collider == null || cell.IsStale)
                cell.Triangles = -1;
            (cell.Collider, cell.IsStale) = (null, false);
        }
    }
}
