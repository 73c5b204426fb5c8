using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Feeds;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Opens clouds that only exist as files, and brings each of their states into the stream: waves of a preview,
    /// generations of a build, the finished cloud.</summary>
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
            Group.IsOpening = false;
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
                if (m_opened.ContainsKey(entity))
                    continue;
                var file = EntityManager.GetComponentObject<PointCloudFile>(entity);
                bool isNew = file.Error == null && !EntityManager.HasComponent<PointCloudSource>(entity);
                if (string.IsNullOrEmpty(file.Path) || !isNew && !file.LooksAgain)
                    continue;
                file.Error = null;
                file.LooksAgain = false;
                m_opened.Add(entity, new OpenedCloud(file.FullPath, file.FullSources()));
            }
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

        /// <returns>Whether there may be more.</returns>
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
                    Take(entity, cloud, file);
                if (cloud.IsBuildGone && EntityManager.HasComponent<PointCloudSource>(entity))
                    EntityManager.GetComponentObject<PointCloudSource>(entity).WithdrawsBuild = true;
                Group.IsOpening |= !cloud.IsEnded;
                return true;
            }
            catch (Exception e)
            {
                // Any exception ends this cloud, but not the update of the others.
                var failure = PointCloudException.Of(file.FullPath, e);
                file.Error = failure.Message;
                Group.Stream.Report(new StreamFailure(file.FullPath, -1, "cannot be opened: " + failure.Story));
                return false;
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
                Place(entity, facts, file);
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
        void Place(Entity entity, CloudFacts facts, PointCloudFile file)
        {
            var space = UnitySpace.Of(facts.BoundsGeo, file.UnitMetres > 0 ? file.UnitMetres : facts.MetresPerUnit, file.Up);
            if (file.HasOrigin)
                space.OriginGeo = file.OriginGeo;
            space.OriginGeo = space.ToGeo(file.Shift);
            EntityManager.AddComponentData(entity, new PointCloudSpace { Value = space });
            EntityManager.AddComponentData(entity, new PointCloudPlacement());
        }
    }
}
