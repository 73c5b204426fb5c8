#if FASTPOINTS_DOTS_PHYSICS
using System;
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
        readonly UnusedColliders m_unused;
        readonly double3x3 m_linear;

        sealed class Body
        {
            public Entity Entity;
            public BlobAssetReference<Collider> Collider;
        }

        public BodyColliders(in OpenedSurface opened, in PointCloudGround made, in UnitySpace space, in double4x4 toWorld,
            MakeGroundSystem of) : base(opened, GridOf(made.VoxelSize, made.HoleSize), made.HiddenClasses, space) =>
            (m_entities, m_unused, m_linear) = (of.EntityManager, of.Unused, LinearOf(toWorld));

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
            Body body = null;
            try
            {
                yield return job;
                body = new Body { Collider = made.Value };
                body.Entity = m_entities.CreateEntity(typeof(LocalToWorld), typeof(PhysicsCollider), typeof(PhysicsWorldIndex));
                m_entities.SetComponentData(body.Entity, new PhysicsCollider { Value = body.Collider });
                Cells.SetMade(cell, surface.TriangleCount, body);
                Move(cell);
            }
            finally
            {
                job.Complete();
                if (body == null && made.Value.IsCreated)
                    made.Value.Dispose();
                made.Dispose();
            }
        }

        // Somebody may have destroyed its entity.
        protected override void Hide(SurfaceCell cell)
        {
            var body = (Body)cell.Shown;
            if (m_entities.Exists(body.Entity))
                m_entities.DestroyEntity(body.Entity);
            m_unused.Add(body.Collider);
        }

        protected override void Move(SurfaceCell cell)
        {
            var body = (Body)cell.Shown;
            if (body != null && m_entities.Exists(body.Entity))
                m_entities.SetComponentData(body.Entity,
                    new LocalToWorld { Value = float4x4.Translate((float3)WorldOf(cell.At)) });
        }
    }

    /// <summary>Colliders whose bodies are gone. The physics world knows them until it is built again, and queries read
    /// it.</summary>
    internal sealed class UnusedColliders : IDisposable
    {
        const int StepsToFree = 8; // Custom physics worlds have steps of their own in each step.

        readonly Queue<(long Step, BlobAssetReference<Collider> Collider)> m_all =
            new Queue<(long Step, BlobAssetReference<Collider> Collider)>();
        long m_step;

        public void Add(BlobAssetReference<Collider> collider) => m_all.Enqueue((m_step, collider));

        /// <summary>Before the world is built.</summary>
        public void Step()
        {
            for (m_step++; m_all.Count > 0 && m_all.Peek().Step < m_step - StepsToFree;)
                m_all.Dequeue().Collider.Dispose();
        }

        public void Dispose()
        {
            while (m_all.Count > 0)
                m_all.Dequeue().Collider.Dispose();
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
