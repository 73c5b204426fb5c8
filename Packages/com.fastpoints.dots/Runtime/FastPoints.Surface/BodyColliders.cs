#if FASTPOINTS_DOTS_PHYSICS
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Entities;
using Unity.Jobs;
using Unity.Mathematics;
using Unity.Physics;
using Unity.Transforms;

namespace FastPoints.Surface
{
    /// <summary>com.unity.physics: a static body for each cell, an entity of its own. Bodies have no scale along axes: what the
    /// cloud's transform does but moving is in their triangles.</summary>
    internal sealed class BodyColliders : SurfaceColliders
    {
        readonly EntityManager m_entities;
        readonly MakeGroundSystem m_system;
        readonly double3x3 m_linear;

        public BodyColliders(in OpenedSurface opened, in PointCloudGround made, in UnitySpace space, in double4x4 toWorld,
            MakeGroundSystem system) : base(opened, GridOf(made.VoxelSize, made.HoleSize), made.HiddenClasses, space) =>
            (m_entities, m_system, m_linear) = (system.EntityManager, system, LinearOf(toWorld));

        public bool IsMadeBy(in PointCloudGround made, in UnitySpace space, in double4x4 toWorld) =>
            IsMadeBy(GridOf(made.VoxelSize, made.HoleSize), made.HiddenClasses, space) && m_linear.Equals(LinearOf(toWorld));

        public override void Dispose()
        {
            base.Dispose();
            foreach (var cell in Cells.Made)
                if (cell.Shown != null)
                    Hide(cell);
        }

        protected override IEnumerator<JobStep> Show(SurfaceCell cell, PackedSurface surface)
        {
            var made = new NativeReference<BlobAssetReference<Collider>>(Allocator.Persistent);
            var job = new CreateColliderJob { Linear = m_linear, Surface = surface, Made = made }.Schedule();
            try
            {
                yield return job;
                var entity = m_entities.CreateEntity(typeof(LocalToWorld), typeof(PhysicsCollider), typeof(PhysicsWorldIndex));
                m_entities.SetComponentData(entity, new PhysicsCollider { Value = made.Value });
                cell.Shown = (entity, made.Value);
                Move(cell);
            }
            finally
            {
                job.Complete();
                if (cell.Shown == null && made.Value.IsCreated)
                    made.Value.Dispose();
                made.Dispose();
            }
        }

        // Somebody may have destroyed its entity.
        protected override void Hide(SurfaceCell cell)
        {
            var (entity, collider) = ((Entity, BlobAssetReference<Collider>))cell.Shown;
            if (m_entities.Exists(entity))
                m_entities.DestroyEntity(entity);
            m_system.FreeLater(collider);
        }

        protected override void Move(SurfaceCell cell)
        {
            var (entity, _) = ((Entity, BlobAssetReference<Collider>))cell.Shown;
            if (m_entities.Exists(entity))
                m_entities.SetComponentData(entity, new LocalToWorld { Value = float4x4.Translate((float3)WorldOf(cell.At)) });
        }
    }

    /// <summary>Some ten milliseconds that cannot be cut, as those of PhysX.</summary>
    [BurstCompile]
    internal struct CreateColliderJob : IJob
    {
        public double3x3 Linear;
        [ReadOnly] public PackedSurface Surface;
        public NativeReference<BlobAssetReference<Collider>> Made;

        public void Execute()
        {
            var vertices = new NativeArray<float3>(Surface.Vertices, Allocator.Temp);
            for (int i = 0; i < vertices.Length; i++)
                vertices[i] = (float3)math.mul(Linear, new double3(vertices[i]));
            Made.Value = MeshCollider.Create(vertices, Surface.Triangles);
        }
    }
}
#endif
