#if FASTPOINTS_DOTS_PHYSICS
using System;
using System.Collections.Generic;
using FastPoints.Entities;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Physics.Systems;
using Unity.Transforms;
using UnityEngine;

namespace FastPoints.Surface
{
    /// <summary>Makes and frees the bodies of each <see cref="PointCloudGround"/>, before a step of physics sees them.</summary>
    [UpdateInGroup(typeof(BeforePhysicsSystemGroup))]
    internal partial class MakeGroundSystem : SystemBase
    {
        readonly Dictionary<Entity, GroundOfCloud> m_all = new Dictionary<Entity, GroundOfCloud>();
        readonly List<Entity> m_gone = new List<Entity>();
        readonly List<double3> m_near = new List<double3>();
        EntityQuery m_clouds, m_followed;
        long m_step;

        public UnusedColliders Unused { get; } = new UnusedColliders();

        public bool IsReady(Entity cloud, float3 position, float reach) =>
            m_all.TryGetValue(cloud, out var ground) && ground.Surface != null && ground.Surface.IsReady(position, reach);

        protected override void OnCreate()
        {
            m_clouds = GetEntityQuery(ComponentType.ReadOnly<PointCloudGround>(), ComponentType.ReadOnly<PointCloudFile>(),
                ComponentType.ReadOnly<PointCloudPathByte>(), ComponentType.ReadOnly<LocalToWorld>());
            m_followed = GetEntityQuery(ComponentType.ReadOnly<PointCloudGround.Followed>(),
                ComponentType.ReadOnly<LocalToWorld>());
        }

        protected override void OnUpdate()
        {
            Unused.Step();
            if (m_all.Count == 0 && m_clouds.IsEmpty)
                return;
            m_near.Clear();
            using (var places = m_followed.ToComponentDataArray<LocalToWorld>(Allocator.Temp))
                foreach (var place in places)
                    m_near.Add(place.Value.c3.xyz);
            m_step++;
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
                    m_gone.Add(cloud);
            foreach (var cloud in m_gone)
                if (m_all.Remove(cloud, out var ground))
                    ground.Reopen();
            m_gone.Clear();
        }

        protected override void OnDestroy()
        {
            foreach (var ground in m_all.Values)
                ground.Reopen();
            m_all.Clear();
            Unused.Dispose();
        }
    }

    sealed class GroundOfCloud
    {
        readonly MakeGroundSystem m_system;
        readonly Entity m_cloud;
        PoolTask<OpenedSurface> m_opening;
        double m_retryAt;
        int m_edits = EditJournal.Writes;
        byte[] m_paths = new byte[0];
        string m_path, m_error;

        public GroundOfCloud(MakeGroundSystem system, Entity cloud) => (m_system, m_cloud) = (system, cloud);

        public BodyColliders Surface { get; private set; }
        public long LastStep;

        public void Reopen()
        {
            m_opening?.Dispose();
            Surface?.Dispose();
            (m_opening, Surface, m_retryAt) = (null, null, 0);
        }

        public void Update(List<double3> near)
        {
            double now = Time.realtimeSinceStartupAsDouble;
            try
            {
                var paths = PointCloudPaths.BytesOf(m_system.EntityManager.GetBuffer<PointCloudPathByte>(m_cloud, true));
                if (m_edits != EditJournal.Writes || !paths.SequenceEqual(m_paths))
                {
                    Reopen();
                    (m_edits, m_paths) = (EditJournal.Writes, paths.ToArray());
                    m_path = PointCloudPaths.Of(m_paths).FullPath;
                }
                var ground = m_system.EntityManager.GetComponentData<PointCloudGround>(m_cloud);
                if (Surface == null ? TryOpen(ground, now) : Follow(ground, near, now))
                    m_error = null;
            }
            catch (Exception e)
            {
                m_retryAt = now + SurfaceColliders.RetrySeconds;
                string message = PointCloudException.Of(m_path, e).Message;
                if (m_error != message)
                    Debug.LogError("FastPoints: a cloud lacks ground: " + message);
                m_error = message;
            }
        }

        bool Follow(in PointCloudGround ground, List<double3> near, double now)
        {
            var (space, toWorld) = SpaceOf(Surface.Manifest);
            if (!Surface.IsMadeBy(ground, space, toWorld))
            {
                Reopen();
                return false;
            }
            (Surface.Cells.MaxCells, Surface.Cells.MaxTriangles) = (ground.MaxCells, ground.MaxTriangles);
            Surface.Follow(space, toWorld, near, ground.Radius);
            return Surface.Update(now, ground.StepMs);
        }

        bool TryOpen(in PointCloudGround ground, double now)
        {
            if (m_opening == null && now >= m_retryAt)
                m_opening = OpenedSurface.Begin(m_path, ground.CacheMegabytes);
            if (m_opening == null || !m_opening.IsDone)
                return false;
            var opening = m_opening;
            m_opening = null;
            var opened = opening.Take();
            var (space, toWorld) = SpaceOf(opened.Folder.Manifest);
            Surface = new BodyColliders(opened, ground, space, toWorld, m_system);
            return true;
        }

        (UnitySpace Space, double4x4 ToWorld) SpaceOf(CloudManifest manifest)
        {
            var entities = m_system.EntityManager;
            var space = entities.HasComponent<PointCloudSpace>(m_cloud) ? entities.GetComponentData<PointCloudSpace>(m_cloud).Value
                : entities.GetComponentData<PointCloudFile>(m_cloud).SpaceOf(manifest.BoundsGeo, manifest.Crs.Units);
            return (space, new double4x4(entities.GetComponentData<LocalToWorld>(m_cloud).Value));
        }
    }
}
#endif
