#if FASTPOINTS_DOTS_PHYSICS
using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Entities;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Entities;
using Unity.Jobs;
using Unity.Mathematics;
using Unity.Physics;
using Unity.Physics.Systems;
using Unity.Transforms;

namespace FastPoints.Surface
{
    /// <summary>Ground and walls of a converted cloud for com.unity.physics, near entities with <see cref="Followed"/>: on the
    /// entity of a cloud, beside its PointCloudFile. Bodies come and go as the colliders of PointCloudCollider do; a cloud that
    /// is turned or scaled, or has another filter, is made anew. Begin with <see cref="Default"/>.</summary>
    public struct PointCloudGround : IComponentData
    {
        /// <summary>What moves, with a LocalToWorld: there are bodies around it, and nowhere else.</summary>
        public struct Followed : IComponentData { }

        public float Radius;
        public float VoxelSize;
        public float HoleSize;
        public ClassMask HiddenClasses;
        public int MaxCells;
        public int MaxTriangles;
        public int CacheMegabytes;

        /// <summary>Which bodies its bodies collide with, and which queries find them; all of them if nothing is set.</summary>
        public CollisionFilter Filter;

        /// <summary>Time of the main thread in each step of physics, in ms, while cells are made.</summary>
        public float StepMs;

        public static PointCloudGround Default => new PointCloudGround
        {
            Radius = 10,
            VoxelSize = 0.1f,
            HoleSize = 0.3f,
            MaxCells = 256,
            MaxTriangles = 1_000_000,
            CacheMegabytes = 256,
            Filter = CollisionFilter.Default,
            StepMs = 0.5f,
        };

        /// <summary>Whether the cells of a cloud around a position of the world are made, with ground in them or
        /// without.</summary>
        public static bool IsReady(World world, Entity cloud, float3 position, float reach = 2) =>
            world.GetExistingSystemManaged<MakeGroundSystem>()?.IsReady(cloud, position, reach) == true;
    }

    /// <summary>Makes and frees the bodies of each <see cref="PointCloudGround"/>, before a step of physics sees them.</summary>
    [UpdateInGroup(typeof(BeforePhysicsSystemGroup))]
    internal partial class MakeGroundSystem : SystemBase
    {
        const int StepsToFree = 8; // Custom physics worlds have steps of their own in each step.

        readonly Dictionary<Entity, GroundOfCloud> m_all = new Dictionary<Entity, GroundOfCloud>();
        readonly List<Entity> m_removed = new List<Entity>();
        readonly List<double3> m_near = new List<double3>();
        readonly Queue<(long Step, BlobAssetReference<Collider> Collider)> m_unused =
            new Queue<(long Step, BlobAssetReference<Collider> Collider)>();
        EntityQuery m_clouds, m_followed;
        long m_step;

        /// <summary>The physics world has a collider until it is built again, and queries read it.</summary>
        public void FreeLater(BlobAssetReference<Collider> collider) => m_unused.Enqueue((m_step, collider));

        public bool IsReady(Entity cloud, float3 position, float reach) => m_all.TryGetValue(cloud, out var ground) &&
            ground.Updates.Surface != null && ground.Updates.Surface.IsReady(position, reach);

        protected override void OnCreate()
        {
            m_clouds = GetEntityQuery(ComponentType.ReadOnly<PointCloudGround>(), ComponentType.ReadOnly<PointCloudFile>(),
                ComponentType.ReadOnly<PointCloudPathByte>(), ComponentType.ReadOnly<LocalToWorld>());
            m_followed = GetEntityQuery(ComponentType.ReadOnly<PointCloudGround.Followed>(),
                ComponentType.ReadOnly<LocalToWorld>());
        }

        protected override void OnUpdate()
        {
            for (m_step++; m_unused.Count > 0 && m_unused.Peek().Step < m_step - StepsToFree;)
                m_unused.Dequeue().Collider.Dispose();
            if (m_all.Count == 0 && m_clouds.IsEmpty)
                return;
            m_near.Clear();
            using (var places = m_followed.ToComponentDataArray<LocalToWorld>(Allocator.Temp))
                foreach (var place in places)
                    m_near.Add(place.Value.c3.xyz);
            using var clouds = m_clouds.ToEntityArray(Allocator.Temp);
            foreach (var cloud in clouds)
            {
                if (!m_all.TryGetValue(cloud, out var ground))
                    m_all.Add(cloud, ground = new GroundOfCloud(this, cloud));
                ground.LastStep = m_step;
                ground.Update(m_near);
            }
            foreach (var (cloud, ground) in m_all)
                if (ground.LastStep != m_step)
                    m_removed.Add(cloud);
            foreach (var cloud in m_removed)
                if (m_all.Remove(cloud, out var ground))
                    ground.Updates.Reopen();
            m_removed.Clear();
        }

        protected override void OnDestroy()
        {
            foreach (var ground in m_all.Values)
                ground.Updates.Reopen();
            m_all.Clear();
            while (m_unused.Count > 0)
                m_unused.Dequeue().Collider.Dispose();
        }
    }

    sealed class GroundOfCloud
    {
        readonly MakeGroundSystem m_system;
        readonly Entity m_cloud;
        byte[] m_paths = new byte[0];
        PointCloudGround m_ground;
        List<double3> m_near;

        public GroundOfCloud(MakeGroundSystem system, Entity cloud)
        {
            (m_system, m_cloud) = (system, cloud);
            Updates = new SurfaceUpdates(() => PointCloudPaths.Of(m_paths).FullPath, Make, Follow);
        }

        public SurfaceUpdates Updates { get; }
        public long LastStep;

        public void Update(List<double3> near)
        {
            var paths = PointCloudPaths.BytesOf(m_system.EntityManager.GetBuffer<PointCloudPathByte>(m_cloud, true));
            if (!paths.SequenceEqual(m_paths))
            {
                Updates.Reopen();
                m_paths = paths.ToArray();
            }
            (m_near, m_ground) = (near, m_system.EntityManager.GetComponentData<PointCloudGround>(m_cloud));
            Updates.Update("a cloud", m_ground.CacheMegabytes, m_ground.StepMs);
        }

        SurfaceColliders Make(OpenedSurface opened)
        {
            var (space, toWorld) = SpaceOf(opened.Folder.Manifest);
            if (BodyColliders.FindProblem(m_ground, toWorld) is string problem)
            {
                opened.Dispose();
                throw new PointCloudException(FailureCode.Unsupported, PointCloudPaths.Of(m_paths).FullPath, -1, problem);
            }
            return new BodyColliders(opened, m_ground, space, toWorld, m_system);
        }

        bool Follow(SurfaceColliders surface)
        {
            var (space, toWorld) = SpaceOf(surface.Manifest);
            if (!((BodyColliders)surface).IsMadeBy(m_ground, space, toWorld))
                return false;
            (surface.Cells.MaxCells, surface.Cells.MaxTriangles) = (m_ground.MaxCells, m_ground.MaxTriangles);
            surface.Follow(space, toWorld, m_near, m_ground.Radius);
            return true;
        }

        (UnityLocalSpace Space, double4x4 ToWorld) SpaceOf(CloudManifest manifest)
        {
            var entities = m_system.EntityManager;
            var space = entities.HasComponent<PointCloudSpace>(m_cloud)
                ? entities.GetComponentData<PointCloudSpace>(m_cloud).Value
                : entities.GetComponentData<PointCloudFile>(m_cloud).SpaceOf(manifest.BoundsGeo, manifest.Crs.Units);
            return (space, new double4x4(entities.GetComponentData<LocalToWorld>(m_cloud).Value));
        }
    }

    /// <summary>com.unity.physics: a static body for each cell, an entity of its own. Bodies have no scale along axes: what the
    /// cloud's transform does but moving is in their triangles.</summary>
    internal sealed class BodyColliders : SurfaceColliders
    {
        // Unity.Physics leaves out triangles of less than 1.6 cm2, without a word: here 0.3 % of the area, half of it at 2 cm.
        const double MinVoxelMetres = 0.04;

        readonly EntityManager m_entities;
        readonly MakeGroundSystem m_system;
        readonly double3x3 m_linear;
        readonly CollisionFilter m_filter;

        public BodyColliders(in OpenedSurface opened, in PointCloudGround made, in UnityLocalSpace space, in double4x4 toWorld,
            MakeGroundSystem system) : base(opened, GridOf(made.VoxelSize, made.HoleSize), made.HiddenClasses, space) =>
            (m_entities, m_system, m_linear, m_filter) = (system.EntityManager, system, LinearOf(toWorld), FilterOf(made));

        public bool IsMadeBy(in PointCloudGround made, in UnityLocalSpace space, in double4x4 toWorld) =>
            IsMadeBy(GridOf(made.VoxelSize, made.HoleSize), made.HiddenClasses, space) && m_linear.Equals(LinearOf(toWorld)) &&
            m_filter.Equals(FilterOf(made));

        static CollisionFilter FilterOf(in PointCloudGround made) =>
            made.Filter.Equals(default) ? CollisionFilter.Default : made.Filter;

        /// <summary>Why bodies would have gaps; null if they would not.</summary>
        public static string FindProblem(in PointCloudGround made, in double4x4 toWorld)
        {
            var linear = LinearOf(toWorld);
            var lengths = new double3(math.length(linear.c0), math.length(linear.c1), math.length(linear.c2));
            double edge = GridOf(made.VoxelSize, made.HoleSize).VoxelMetres *
                math.sqrt(lengths.x * lengths.y * lengths.z / math.cmax(lengths));
            return !(edge > 0 && edge < 0.999 * MinVoxelMetres) ? null : "voxels of " + NumberText.Of(Math.Round(edge, 4)) +
                " m in the world are too small for com.unity.physics: wanted at least " + NumberText.Of(MinVoxelMetres) + " m";
        }

        public override void Dispose()
        {
            base.Dispose();
            foreach (var cell in Cells.Made)
                if (cell.Collider != null)
                    Hide(cell);
        }

        protected override IEnumerator<JobStep> Show(SurfaceCell cell, PackedSurface surface)
        {
            var made = new NativeReference<BlobAssetReference<Collider>>(Allocator.Persistent);
            var job = new CreateColliderJob { Linear = m_linear, Surface = surface, Filter = m_filter, Made = made }.Schedule();
            bool isShown = false;
            try
            {
                yield return job;
                var entity = m_entities.CreateEntity(typeof(LocalToWorld), typeof(PhysicsCollider), typeof(PhysicsWorldIndex));
                m_entities.SetComponentData(entity, new PhysicsCollider { Value = made.Value });
                Replace(cell, (entity, made.Value));
                isShown = true;
                Move(cell);
            }
            finally
            {
                job.Complete();
                if (!isShown && made.Value.IsCreated)
                    made.Value.Dispose();
                made.Dispose();
            }
        }

        // Somebody may have destroyed its entity.
        protected override void Hide(SurfaceCell cell)
        {
            var (entity, collider) = ((Entity, BlobAssetReference<Collider>))cell.Collider;
            if (m_entities.Exists(entity))
                m_entities.DestroyEntity(entity);
            m_system.FreeLater(collider);
        }

        protected override void Move(SurfaceCell cell)
        {
            var (entity, _) = ((Entity, BlobAssetReference<Collider>))cell.Collider;
            if (m_entities.Exists(entity))
                m_entities.SetComponentData(entity, new LocalToWorld { Value = float4x4.Translate((float3)WorldOf(cell.At)) });
        }
    }

    /// <summary>It cannot be cut, as PhysX's. Without Burst, 25,000 triangles, a full cell, take some 100 ms.</summary>
    [BurstCompile]
    internal struct CreateColliderJob : IJob
    {
        public double3x3 Linear;
        [ReadOnly] public PackedSurface Surface;
        public CollisionFilter Filter;
        public NativeReference<BlobAssetReference<Collider>> Made;

        public void Execute()
        {
            var vertices = new NativeArray<float3>(Surface.Vertices, Allocator.Temp);
            for (int i = 0; i < vertices.Length; i++)
                vertices[i] = (float3)math.mul(Linear, new double3(vertices[i]));
            Made.Value = MeshCollider.Create(vertices, Surface.Triangles, Filter);
        }
    }
}
#endif
