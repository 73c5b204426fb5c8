using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Feeds;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;

namespace FastPoints.Entities
{
    /// <summary>Opens clouds that only exist as files, and brings each of their states into the stream: waves of a preview,
    /// generations of a build, the finished cloud. Files that change are opened again, or placed elsewhere.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateBefore(typeof(AddCloudsSystem))]
    internal partial class OpenCloudsSystem : StreamSystem
    {
        /// <summary>Main-thread time in each frame for all previews together.</summary>
        const double BudgetMs = 2;

        readonly Dictionary<Entity, OpenedCloud> m_opened = new Dictionary<Entity, OpenedCloud>();
        readonly List<OpenedCloud> m_leaving = new List<OpenedCloud>();
        readonly List<Entity> m_ended = new List<Entity>();
        EntityQuery m_files;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_files = GetEntityQuery(ComponentType.ReadOnly<PointCloudFile>());
        }

        protected override void OnUpdate()
        {
            Group.IsOpening = Group.IsFollowing = false;
            if (!m_files.IsEmpty)
                Begin();
            if (m_opened.Count > 0)
                UpdateOpened();
            for (int i = m_leaving.Count - 1; i >= 0; i--)
            {
                if (!m_leaving[i].IsOpen)
                    continue;
                m_leaving[i].Dispose();
                m_leaving.RemoveAt(i);
            }
        }

        protected override void OnDestroy()
        {
            foreach (var opened in m_opened.Values)
                opened.Dispose();
            foreach (var leaving in m_leaving)
                leaving.Dispose();
            m_opened.Clear();
            m_leaving.Clear();
            base.OnDestroy();
        }

        void Begin()
        {
            using var entities = m_files.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
            {
                var file = EntityManager.GetComponentObject<PointCloudFile>(entity);
                bool isOpened = m_opened.TryGetValue(entity, out var opened), isSame = isOpened && opened.As.OpensLike(file);
                if (isSame && (file.Error == null || !file.LooksAgain))
                {
                    Move(entity, file, opened);
                    continue;
                }
                if (isOpened)
                    End(entity, opened, !isSame);
                if (isOpened && !isSame)
                {
                    // What is shown leaves in this frame, and the next one opens.
                    file.Error = null;
                    continue;
                }
                bool isNew = file.Error == null && !EntityManager.HasComponent<PointCloudSource>(entity);
                if (string.IsNullOrEmpty(file.Path) || !isOpened && !isNew && !file.LooksAgain)
                    continue;
                file.Error = null;
                file.LooksAgain = false;
                opened = new OpenedCloud(file);
                m_opened.Add(entity, opened);
                Move(entity, file, opened);
            }
        }

        /// <param name="hides">Whether what is shown of it goes.</param>
        void End(Entity entity, OpenedCloud opened, bool hides)
        {
            m_leaving.Add(opened);
            m_opened.Remove(entity);
            if (!hides)
                return;
            // Without a placement it leaves the stream.
            EntityManager.RemoveComponent<PointCloudPlacement>(entity);
            EntityManager.RemoveComponent<PointCloudSource>(entity);
            EntityManager.RemoveComponent<PointCloudSpace>(entity);
            EntityManager.RemoveComponent<PointCloudStates>(entity);
            EntityManager.RemoveComponent<PointCloudLook>(entity);
        }

        /// <summary>Follows the origin of a cloud, and of the world.</summary>
        void Move(Entity entity, PointCloudFile file, OpenedCloud opened)
        {
            double3 local = default;
            if (file.GameObject == null && !opened.WorldShift.Equals(Group.Shift) &&
                EntityManager.HasComponent<LocalToWorld>(entity))
            {
                var toWorld = new double4x4(EntityManager.GetComponentData<LocalToWorld>(entity).Value);
                var linear = new double3x3(toWorld.c0.xyz, toWorld.c1.xyz, toWorld.c2.xyz);
                // What has no transform yet is not there.
                if (math.determinant(linear) != 0)
                {
                    local = math.mul(math.inverse(linear), Group.Shift - opened.WorldShift);
                    opened.Shift += local;
                    opened.WorldShift = Group.Shift;
                }
            }
            bool isElsewhere = file.HasOrigin && !(opened.As.HasOrigin && opened.As.OriginGeo.Equals(file.OriginGeo));
            (opened.As.HasOrigin, opened.As.OriginGeo) = (file.HasOrigin, file.OriginGeo);
            if (!isElsewhere && local.Equals(default) || !EntityManager.HasComponent<PointCloudSpace>(entity))
                return;
            var space = EntityManager.GetComponentData<PointCloudSpace>(entity);
            if (isElsewhere)
                (space.Value.OriginGeo, local) = (file.OriginGeo, opened.Shift);
            space.Value.OriginGeo = space.Value.ToGeo(local);
            EntityManager.SetComponentData(entity, space);
        }

        void UpdateOpened()
        {
            m_ended.Clear();
            double budgetMs = BudgetMs / m_opened.Count;
            foreach (var opened in m_opened)
                if (!TryUpdate(opened.Key, opened.Value, budgetMs))
                    m_ended.Add(opened.Key);
            foreach (var entity in m_ended)
            {
                m_leaving.Add(m_opened[entity]);
                m_opened.Remove(entity);
            }
        }

        /// <returns>Whether the entity is there.</returns>
        bool TryUpdate(Entity entity, OpenedCloud cloud, double budgetMs)
        {
            if (!EntityManager.HasComponent<PointCloudFile>(entity))
                return false;
            var file = EntityManager.GetComponentObject<PointCloudFile>(entity);
            try
            {
                if (file.LooksAgain)
                    cloud.Refresh();
                file.LooksAgain = false;
                cloud.Update(budgetMs);
                if (cloud.Newest != null)
                {
                    Group.Wake();
                    Take(entity, cloud, file);
                }
                if (cloud.IsBuildGone && EntityManager.HasComponent<PointCloudSource>(entity))
                    EntityManager.GetComponentObject<PointCloudSource>(entity).WithdrawsBuild = true;
                Group.IsOpening |= !cloud.IsAtRest;
                Group.IsFollowing |= cloud.IsFollowed;
                return true;
            }
            catch (Exception e)
            {
                // Any exception ends this cloud, but not the update of the others.
                var failure = PointCloudException.Of(file.FullPath, e);
                file.Error = failure.Message;
                Group.Stream.Report(new StreamFailure(file.FullPath, -1, "cannot be opened: " + failure.Story));
                cloud.Dispose();
                return true;
            }
        }

        /// <summary>Takes one state after the other: the next one only when the one before is shown.</summary>
        void Take(Entity entity, OpenedCloud cloud, PointCloudFile file)
        {
            if (!EntityManager.HasComponent<PointCloudSource>(entity))
            {
                var facts = cloud.Newest;
                var first = new PointCloudSource();
                cloud.TakeInto(first, file);
                Place(entity, facts, file, cloud.Shift);
                EntityManager.AddComponentObject(entity, first);
                return;
            }
            var source = EntityManager.GetComponentObject<PointCloudSource>(entity);
            bool isPending = source.Source != null || !EntityManager.HasComponent<StreamedPointCloud>(entity) ||
                EntityManager.GetComponentData<StreamedPointCloud>(entity).Next != CloudSuccession.None;
            if (!isPending)
                cloud.TakeInto(source, file);
        }

        /// <summary>Places all states where the first one stood, so that nothing moves when it is replaced.</summary>
        void Place(Entity entity, CloudFacts facts, PointCloudFile file, double3 shift)
        {
            var space = UnitySpace.Of(facts.BoundsGeo, file.UnitMetres > 0 ? file.UnitMetres : facts.MetresPerUnit, file.Up);
            if (file.HasOrigin)
                space.OriginGeo = file.OriginGeo;
            space.OriginGeo = space.ToGeo(shift);
            EntityManager.AddComponentData(entity, new PointCloudSpace { Value = space });
            EntityManager.AddComponentData(entity, new PointCloudPlacement());
        }
    }
}
