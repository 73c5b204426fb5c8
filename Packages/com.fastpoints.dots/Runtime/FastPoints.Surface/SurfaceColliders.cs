#if FASTPOINTS_PHYSICS
using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Entities;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace FastPoints.Surface
{
    /// <summary>The colliders of an open cloud near what moves, made one cell at a time, from a pool. Cells are counted in metres
    /// from the corner of the cloud's root, in double; the space that the cloud is shown in places them. Main thread.</summary>
    internal sealed class SurfaceColliders : IDisposable
    {
        public const double RetrySeconds = 5;
        const long PointsPerBatch = 300_000; // Of a cell at once: 7 MB.
        const double MinMove = 0.125; // Of a cell: what has moved less changes no plan.
        const double MaxScaleChange = 1e-3; // Metres of a degree change with the place: beyond this all is made anew.

        readonly CloudFolder m_folder;
        readonly SurfaceGrid m_grid;
        readonly ClassMask m_hidden;
        readonly PointCloud m_cloud;
        readonly SurfaceCache m_cache;
        readonly Transform m_parent;
        readonly BoundsGeo m_boundsGeo;
        readonly CloudUnits m_units;
        readonly SurfacePointReader m_points;
        readonly SurfaceBuilder m_builder;
        readonly double3 m_rootGeo, m_scale;
        readonly double3x3 m_fromCloud;
        readonly Stack<(MeshCollider, Mesh)> m_free = new Stack<(MeshCollider, Mesh)>();
        readonly List<Object> m_owned = new List<Object>();
        List<double3> m_places = new List<double3>(), m_planned = new List<double3>();
        UnitySpace m_space;
        double4x4 m_toWorld;
        double3 m_lengths;
        double m_radius;
        bool m_isStale = true;
        JobCoroutine m_making;
        PoolTask<bool> m_writing;

        /// <param name="opened">Is owned from now on.</param>
        public SurfaceColliders(in OpenedSurface opened, in SurfaceGrid grid, ClassMask hidden, PointCloud cloud)
        {
            var folder = opened.Folder;
            (m_folder, m_grid, m_hidden, m_cloud, m_parent) = (folder, grid, hidden, cloud, cloud.transform);
            (m_boundsGeo, m_units) = (folder.Manifest.BoundsGeo, folder.Manifest.Crs.Units);
            var space = m_space = cloud.SpaceOf(m_boundsGeo, m_units);
            m_scale = space.Scale;
            m_rootGeo = folder.Manifest.Grid.ToGeo(folder.Manifest.Root.Corner);
            space.Up.Directions(out var east, out var north, out var up);
            m_fromCloud = math.transpose(new double3x3(east, up, north));
            m_points = new SurfacePointReader(folder, grid, hidden, m_scale) { PointsPerBatch = PointsPerBatch, Edits = opened.Edits };
            m_builder = new SurfaceBuilder(grid, (float3)up);
            m_cache = opened.Cache;
            m_cache?.Begin(grid, hidden, m_scale, space.Up);
            Cells = new SurfaceCells(grid, collider => Return(collider, null));
        }

        public SurfaceCells Cells { get; }
        public bool IsMaking => m_making != null && !m_making.IsDone;
        public bool IsWriting => m_writing != null && !m_writing.IsDone;

        /// <summary>Plans anew where something has moved, and moves colliders where the cloud's origin has.</summary>
        /// <returns>False if it was made in another way than is wanted.</returns>
        public bool Follow(List<Transform> followed, double radius, in SurfaceGrid grid, ClassMask hidden)
        {
            var space = m_cloud.SpaceOf(m_boundsGeo, m_units);
            if (!m_grid.Equals(grid) || !m_hidden.Equals(hidden) || m_space.Up != space.Up ||
                math.any(math.abs(space.Scale - m_scale) > MaxScaleChange * m_scale))
                return false;
            bool isElsewhere = !m_space.OriginGeo.Equals(space.OriginGeo);
            (m_space, m_toWorld) = (space, new double4x4(TransformMatrix.Of(m_parent).Value));
            foreach (var cell in Cells.Made)
                if (isElsewhere && cell.Collider != null)
                    cell.Collider.transform.localPosition = PositionOf(cell.At);
            var toAxes = math.mul(LinearOf(m_toWorld), m_fromCloud);
            var lengths = new double3(math.length(toAxes.c0), math.length(toAxes.c1), math.length(toAxes.c2));
            m_places.Clear();
            foreach (var transform in followed)
                if (transform != null && math.determinant(toAxes) != 0)
                    m_places.Add(MetresOf(transform.position));
            bool isStale = m_isStale || m_radius != radius || !m_lengths.Equals(lengths) || m_places.Count != m_planned.Count;
            for (int i = 0; i < m_places.Count && !isStale; i++)
                isStale = math.distance(m_places[i], m_planned[i]) > MinMove * m_grid.CellMetres;
            if (!isStale)
                return true;
            (m_radius, m_lengths, m_isStale, m_places, m_planned) = (radius, lengths, false, m_planned, m_places);
            Cells.Plan(m_planned, lengths, radius);
            return true;
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

        public bool IsReady(Vector3 world, double reach) => math.all(m_lengths > 0) &&
            Cells.IsMade(MetresOf(world), reach / m_lengths);

        public void Dispose()
        {
            m_making?.Cancel();
            foreach (var owned in m_owned)
                if (owned != null)
                    Object.Destroy(owned);
            m_builder.Dispose();
            m_points.Dispose();
            m_cache?.Dispose();
            m_folder.Dispose();
        }

        IEnumerator<JobStep> Make(SurfaceCell cell)
        {
            var surface = default(PackedSurface);
            try
            {
                if (m_cache != null)
                    yield return JobStep.Of(PoolTask.Run(m_cache.Folder, () => m_cache.Read(cell.At), read => surface = read,
                        unwanted => unwanted.Dispose()));
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
                if (surface.TriangleCount > 0)
                    yield return JobStep.Of(Show(cell, surface));
                else
                    Cells.SetMade(cell, 0, null);
                while (!isStored && m_cache != null && IsWriting)
                    yield return default;
                if (!isStored && m_cache != null)
                    BeginWriting(cell.At, ref surface);
            }
            finally
            {
                surface.Dispose();
            }
        }

        // It is its from then on.
        void BeginWriting(int3 cell, ref PackedSurface surface)
        {
            var (cache, written) = (m_cache, surface);
            surface = default;
            m_writing = PoolTask.Begin(cache.Folder, () =>
            {
                using (written)
                    cache.Write(cell, written);
                return true;
            });
        }

        IEnumerator<JobStep> Show(SurfaceCell cell, PackedSurface surface)
        {
            var (collider, mesh) = Rent();
            var job = default(JobHandle);
            bool isShown = false;
            try
            {
                mesh.indexFormat = IndexFormat.UInt32;
                mesh.SetVertices(surface.Vertices);
                mesh.SetIndices(surface.Triangles.Reinterpret<int>(3 * sizeof(int)), MeshTopology.Triangles, 0);
#if UNITY_6000_3_OR_NEWER
                job = new BakeMeshJob { Mesh = mesh.GetEntityId() }.Schedule();
#else
                job = new BakeMeshJob { Mesh = mesh.GetInstanceID() }.Schedule();
#endif
                yield return job;
                collider.transform.localPosition = PositionOf(cell.At);
                collider.sharedMesh = mesh;
                collider.gameObject.layer = m_parent.gameObject.layer;
                collider.gameObject.SetActive(isShown = true);
                Cells.SetMade(cell, surface.TriangleCount, collider);
            }
            finally
            {
                job.Complete();
                if (!isShown)
                    Return(collider, mesh);
            }
        }

        (MeshCollider, Mesh) Rent()
        {
            if (m_free.Count > 0)
                return m_free.Pop();
            var cell = new GameObject("Cell of a point cloud") { hideFlags = HideFlags.DontSave };
            var mesh = new Mesh { name = cell.name, hideFlags = HideFlags.DontSave };
            m_owned.AddRange(new Object[] { cell, mesh });
            cell.SetActive(false);
            cell.transform.SetParent(m_parent, false);
            return (cell.AddComponent<MeshCollider>(), mesh);
        }

        void Return(MeshCollider collider, Mesh mesh)
        {
            // Somebody may have deleted what lies below the cloud.
            if (collider == null)
                return;
            mesh ??= collider.sharedMesh;
            collider.gameObject.SetActive(false);
            collider.sharedMesh = null;
            mesh.Clear();
            m_free.Push((collider, mesh));
        }

        Vector3 PositionOf(int3 cell) => Of(m_space.FromGeo(m_rootGeo +
            new double3(cell.x, cell.y, cell.z) * m_grid.CellMetres / m_scale));

        double3 MetresOf(Vector3 world) => (m_space.ToGeo(math.mul(math.inverse(LinearOf(m_toWorld)),
            new double3(world.x, world.y, world.z) - m_toWorld.c3.xyz)) - m_rootGeo) * m_scale;

        static double3x3 LinearOf(double4x4 m) => new double3x3(m.c0.xyz, m.c1.xyz, m.c2.xyz);
        static Vector3 Of(double3 v) => new Vector3((float)v.x, (float)v.y, (float)v.z);
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

    /// <summary>Prepares a mesh for PhysX: some ten milliseconds that cannot be cut. Burst has nothing to compile here.</summary>
    internal struct BakeMeshJob : IJob
    {
#if UNITY_6000_3_OR_NEWER
        public EntityId Mesh;
#else
        public int Mesh;
#endif

        public void Execute() => Physics.BakeMesh(Mesh, false);
    }
}
#endif
