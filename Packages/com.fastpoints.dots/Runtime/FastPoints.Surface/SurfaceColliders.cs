using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    /// <summary>The colliders of an open cloud near what moves, made one cell at a time. Cells are counted in metres from the
    /// corner of the cloud's root, in double; the space that the cloud is shown in places them. Main thread.</summary>
    internal abstract class SurfaceColliders : IDisposable
    {
        public const double RetrySeconds = 5;
        const int CellEdgeVoxels = 80;
        const long PointsPerBatch = 300_000; // Of a cell at once: 7 MB.
        const double MinMove = 0.125; // Of a cell: what has moved less changes no plan.
        const double MaxScaleChange = 1e-3; // Metres of a degree change with the place: beyond this all is made anew.

        readonly OpenedSurface m_opened;
        readonly SurfaceGrid m_grid;
        readonly ClassMask m_hidden;
        readonly SurfacePointReader m_points;
        readonly SurfaceBuilder m_builder;
        readonly double3 m_rootGeo, m_scale;
        readonly double3x3 m_fromCloud;
        List<double3> m_places = new List<double3>(), m_planned = new List<double3>();
        EditPlan m_edits; // Null for the cloud as it is stored.
        UnityLocalSpace m_space;
        double4x4 m_toWorld;
        double3 m_lengths;
        double m_radius;
        bool m_isStale = true;
        JobCoroutine m_making;
        PoolTask<bool> m_writing;

        /// <param name="opened">Is owned from now on.</param>
        protected SurfaceColliders(in OpenedSurface opened, in SurfaceGrid grid, ClassMask hidden, in UnityLocalSpace space)
        {
            var manifest = opened.Folder.Manifest;
            (m_opened, m_grid, m_hidden, m_space, m_scale) = (opened, grid, hidden, space, space.Scale);
            m_rootGeo = manifest.Grid.ToGeo(manifest.Root.Corner);
            space.Up.Directions(out var east, out var north, out var up);
            m_fromCloud = math.transpose(new double3x3(east, up, north));
            m_points = new SurfacePointReader(opened.Folder, grid, hidden, m_scale)
            {
                PointsPerBatch = PointsPerBatch,
                Edits = m_edits = opened.Edits,
            };
            m_builder = new SurfaceBuilder(grid, (float3)up);
            opened.Cache?.Begin(grid, hidden, m_scale, space.Up);
            Cells = new SurfaceCells(grid, Hide);
        }

        public static SurfaceGrid GridOf(float voxelSize, float holeSize) => new SurfaceGrid(math.max(0.001, voxelSize),
            CellEdgeVoxels, (float)math.clamp(holeSize / math.max(0.001, voxelSize), 0, SurfaceGrid.MaxHoleVoxels));

        public CloudManifest Manifest => m_opened.Folder.Manifest;
        public SurfaceCells Cells { get; }
        public bool IsMaking => m_making != null && !m_making.IsDone;
        public bool IsWriting => m_writing != null && !m_writing.IsDone;

        /// <summary>Whether it would be made in the same way.</summary>
        public bool IsMadeBy(in SurfaceGrid grid, ClassMask hidden, in UnityLocalSpace space) => m_grid.Equals(grid) &&
            m_hidden.Equals(hidden) && m_space.Up == space.Up &&
            math.all(math.abs(space.Scale - m_scale) <= MaxScaleChange * m_scale);

        /// <summary>Plans anew where something has moved, and moves colliders where the cloud has.</summary>
        /// <param name="followed">Positions in the world.</param>
        public void Follow(in UnityLocalSpace space, in double4x4 toWorld, List<double3> followed, double radius)
        {
            bool isElsewhere = !m_space.OriginGeo.Equals(space.OriginGeo) || !m_toWorld.Equals(toWorld);
            (m_space, m_toWorld) = (space, toWorld);
            foreach (var cell in Cells.Made)
                if (isElsewhere && cell.Collider != null)
                    Move(cell);
            var toAxes = math.mul(LinearOf(m_toWorld), m_fromCloud);
            var lengths = new double3(math.length(toAxes.c0), math.length(toAxes.c1), math.length(toAxes.c2));
            m_places.Clear();
            foreach (var position in followed)
                if (math.determinant(toAxes) != 0)
                    m_places.Add(MetresOf(position));
            bool isStale = m_isStale || m_radius != radius || !m_lengths.Equals(lengths) || m_places.Count != m_planned.Count;
            for (int i = 0; i < m_places.Count && !isStale; i++)
                isStale = math.distance(m_places[i], m_planned[i]) > MinMove * m_grid.CellMetres;
            if (!isStale)
                return;
            (m_radius, m_lengths, m_isStale, m_places, m_planned) = (radius, lengths, false, m_planned, m_places);
            Cells.Plan(m_planned, lengths, radius);
        }

        /// <summary>Goes on with a cell. Returns whether one was completed.</summary>
        /// <exception cref="PointCloudException">It cannot be made, and is tried again later.</exception>
        public bool Update(double now, double budgetMs)
        {
            if (!IsMaking && (Cells.Busy = Cells.Next(now)) == null)
                return false;
            if (!IsMaking)
                m_making = new JobCoroutine(Make(Cells.Busy));
            Cells.Busy.RetryAt = now + RetrySeconds; // Where it fails.
            return m_isStale |= m_making.Tick(budgetMs);
        }

        /// <summary>Reads the cloud's edits as they are now, and which of them reach the cells of now.</summary>
        public PoolTask<EditedCells> BeginEdits()
        {
            var (path, manifest, cells) = (m_opened.Folder.FolderPath, Manifest, Cells.Known());
            return PoolTask.Begin(path, () =>
            {
                var plan = EditPlan.Of(path, manifest);
                return new EditedCells { Plan = plan, Cells = cells, EditsOfCell = cells.ConvertAll(c => EditsIn(c.At, plan)) };
            });
        }

        /// <summary>Goes on with other edits, while no cell is made: those cells are made anew that they reach.</summary>
        public void SetEdits(in EditedCells edited)
        {
            m_points.Edits = m_edits = edited.Plan;
            for (int i = 0; i < edited.Cells.Count; i++)
                Cells.SetEdits(edited.Cells[i], edited.EditsOfCell[i]);
            m_isStale = true;
        }

        // Any thread.
        ulong EditsIn(int3 cell, EditPlan edits) => edits == null ? 0 : edits.HashIn(m_points.BoxOf(cell));

        public bool IsReady(double3 world, double reach) => math.all(m_lengths > 0) &&
            Cells.IsReady(MetresOf(world), reach / m_lengths);

        public virtual void Dispose()
        {
            m_making?.Cancel();
            m_builder.Dispose();
            m_points.Dispose();
            m_opened.Dispose();
        }

        /// <summary>Coroutine: makes what is shown of a cell, and has it replace what was.</summary>
        protected abstract IEnumerator<JobStep> Show(SurfaceCell cell, PackedSurface surface);

        /// <summary>In one frame, so that nothing falls through meanwhile.</summary>
        protected void Replace(SurfaceCell cell, object collider)
        {
            if (cell.Collider != null)
                Hide(cell);
            cell.Collider = collider;
        }

        protected abstract void Hide(SurfaceCell cell);
        protected abstract void Move(SurfaceCell cell);

        /// <summary>The corner of a cell, in the space that the cloud's transform moves.</summary>
        protected double3 LocalOf(int3 cell) => m_space.FromGeo(m_rootGeo +
            new double3(cell.x, cell.y, cell.z) * m_grid.CellMetres / m_scale);

        protected double3 WorldOf(int3 cell) => math.mul(LinearOf(m_toWorld), LocalOf(cell)) + m_toWorld.c3.xyz;

        IEnumerator<JobStep> Make(SurfaceCell cell)
        {
            var (cache, edits) = (m_opened.Cache, m_edits);
            var surface = default(PackedSurface);
            ulong hash = 0;
            try
            {
                if (cache != null || edits != null)
                    yield return JobStep.Of(PoolTask.Run(m_opened.Folder.FolderPath, () =>
                    {
                        ulong of = EditsIn(cell.At, edits);
                        return (of, cache == null ? default : cache.Read(cell.At, of));
                    }, read => (hash, surface) = read, unwanted => unwanted.Item2.Dispose()));
                bool isStored = surface.Ints.IsCreated;
                if (!isStored)
                {
                    yield return JobStep.Of(m_builder.Run(cell.At, m_points.Add));
                    surface = new PackedSurface(m_builder.Vertices.Length, m_builder.Triangles.Length);
                    yield return JobStep.Of(Slices.Run(0, 1, 1, (first, end, after) => new OrientSurfaceJob
                    {
                        FromSteps = m_fromCloud * (m_grid.VoxelMetres / SurfaceGrid.StepsPerVoxel),
                        Vertices = m_builder.Vertices,
                        Triangles = m_builder.Triangles,
                        Oriented = surface,
                    }.Schedule(after)));
                }
                int triangles = surface.Triangles.Length;
                if (triangles > 0)
                    yield return JobStep.Of(Show(cell, surface));
                else
                    Replace(cell, null);
                Cells.SetMade(cell, triangles, hash);
                while (!isStored && cache != null && IsWriting)
                    yield return default;
                if (!isStored && cache != null)
                    BeginWriting(cell, ref surface);
            }
            finally
            {
                surface.Dispose();
            }
        }

        // It is its from then on.
        void BeginWriting(SurfaceCell cell, ref PackedSurface surface)
        {
            var (cache, at, edits, written) = (m_opened.Cache, cell.At, cell.Edits, surface);
            surface = default;
            m_writing = PoolTask.Begin(cache.Folder, () =>
            {
                using (written)
                    cache.Write(at, edits, written);
                return true;
            });
        }

        double3 MetresOf(double3 world) => (m_space.ToGeo(math.mul(math.inverse(LinearOf(m_toWorld)),
            world - m_toWorld.c3.xyz)) - m_rootGeo) * m_scale;

        protected static double3x3 LinearOf(double4x4 m) => new double3x3(m.c0.xyz, m.c1.xyz, m.c2.xyz);
    }

    /// <summary>What edits reach.</summary>
    internal struct EditedCells
    {
        public EditPlan Plan; // Null for the cloud as it is stored.
        public List<SurfaceCell> Cells;
        public List<ulong> EditsOfCell;
    }

    /// <summary>Opens the cloud of a component and goes on with its colliders: five seconds later after an error, anew where
    /// edits reach. Main thread.</summary>
    internal sealed class SurfaceUpdates
    {
        readonly Func<string> m_path;
        readonly Func<OpenedSurface, SurfaceColliders> m_make;
        readonly Func<SurfaceColliders, bool> m_follow;
        PoolTask<OpenedSurface> m_opening;
        PoolTask<EditedCells> m_editing;
        double m_retryAt;
        int m_edits = EditJournal.Writes;
        int m_versions; // Of surfaces before this one.

        /// <param name="path">Of the cloud; null for none.</param>
        /// <param name="follow">Plans; false if it must be made anew.</param>
        public SurfaceUpdates(Func<string> path, Func<OpenedSurface, SurfaceColliders> make,
            Func<SurfaceColliders, bool> follow) => (m_path, m_make, m_follow) = (path, make, follow);

        public SurfaceColliders Surface { get; private set; }
        public string Error { get; private set; }
        public int Version => m_versions + (Surface?.Cells.Version ?? 0);
        public bool IsCurrent => m_editing == null && m_edits == EditJournal.Writes; // Has all edits.

        public void Reopen()
        {
            m_opening?.Dispose();
            m_versions += 1 + (Surface?.Cells.Version ?? 0);
            Surface?.Dispose();
            (m_opening, m_editing, Surface, m_retryAt) = (null, null, null, 0);
        }

        public void Update(string name, int cacheMegabytes, double budgetMs)
        {
            double now = UnityEngine.Time.realtimeSinceStartupAsDouble;
            try
            {
                int edits = EditJournal.Writes; // Others write meanwhile.
                if (Surface == null ? m_edits != edits : !m_follow(Surface))
                    Reopen();
                if (Surface == null)
                    m_edits = edits;
                if (Surface == null ? TryOpen(cacheMegabytes, now) : !IsEditing(now) && Surface.Update(now, budgetMs))
                    Error = null;
            }
            catch (Exception e)
            {
                m_retryAt = now + SurfaceColliders.RetrySeconds;
                string message = PointCloudException.Of(m_path(), e).Message;
                if (Error != message)
                    UnityEngine.Debug.LogError("FastPoints: " + name + " lacks colliders: " + message);
                Error = message;
            }
        }

        // Whether it waits for edits, which are taken between two cells: where they go on and on, cells do too.
        bool IsEditing(double now)
        {
            if (!IsCurrent && m_editing == null && !Surface.IsMaking && now >= m_retryAt)
                (m_edits, m_editing) = (EditJournal.Writes, Surface.BeginEdits());
            if (m_editing == null || !m_editing.IsDone)
                return m_editing != null;
            var editing = m_editing;
            (m_editing, m_edits) = (null, m_edits - 1); // Not current, where it throws: what was made stands.
            Surface.SetEdits(editing.Take());
            (m_edits, Error) = (m_edits + 1, null);
            return false;
        }

        bool TryOpen(int cacheMegabytes, double now)
        {
            if (m_opening == null && now >= m_retryAt && m_path() is string path)
                m_opening = OpenedSurface.Begin(path, cacheMegabytes);
            if (m_opening == null || !m_opening.IsDone)
                return false;
            var opening = m_opening;
            m_opening = null;
            Surface = m_make(opening.Take());
            return true;
        }
    }

    /// <summary>Turns a surface into Unity's axes, in a fraction of a millisecond. They are left-handed, and fronts are clockwise
    /// there: of each triangle two vertices change places.</summary>
    [BurstCompile]
    internal struct OrientSurfaceJob : IJob
    {
        public double3x3 FromSteps;
        [ReadOnly] public NativeArray<int3> Vertices;
        [ReadOnly] public NativeArray<int3> Triangles;
        public PackedSurface Oriented;

        public void Execute()
        {
            var vertices = Oriented.Vertices;
            for (int i = 0; i < Vertices.Length; i++)
                vertices[i] = (float3)math.mul(FromSteps, (double3)Vertices[i]);
            var triangles = Oriented.Triangles;
            for (int i = 0; i < Triangles.Length; i++)
                triangles[i] = new int3(Triangles[i].x, Triangles[i].z, Triangles[i].y);
        }
    }
}
