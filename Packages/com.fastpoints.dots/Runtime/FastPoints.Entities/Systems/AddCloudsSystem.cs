using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Adds clouds of new entities to the stream and removes those whose entities are gone, follows placements, and
    /// replaces older states by newer ones.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    internal partial class AddCloudsSystem : StreamSystem
    {
        readonly List<Entity> m_removed = new List<Entity>();
        EntityQuery m_streamed;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_streamed = new EntityQueryBuilder(Allocator.Temp).WithAll<StreamedPointCloud>()
                .WithOptions(EntityQueryOptions.IncludeDisabledEntities | EntityQueryOptions.IncludePrefab).Build(this);
        }

        protected override void OnUpdate()
        {
            int streamed = 0;
            foreach (var (entity, live) in Group.Live)
            {
                bool exists = EntityManager.HasComponent<PointCloudPlacement>(entity) &&
                    !EntityManager.HasComponent<Prefab>(entity);
                if (live.Versions != null && !(exists && EntityManager.HasComponent<StreamedPointCloud>(entity)))
                    Remove(entity, live);
                else if (live.NextSource != null && exists && live.Versions == null &&
                    !EntityManager.HasComponent<Disabled>(entity))
                    Add(entity, live);
                if (live.Versions != null)
                    Follow(entity, live);
                else if (!EntityManager.Exists(entity))
                    m_removed.Add(entity);
                streamed += live.Versions != null ? 1 : 0;
            }
            foreach (var entity in m_removed)
                Group.Live.Remove(entity);
            m_removed.Clear();
            if (m_streamed.CalculateEntityCount() != streamed)
                ClearOwners();
        }

        void Add(Entity entity, EntityCloud live)
        {
            var versions = new CloudVersions(Group.Stream);
            if (!TryAdd(live, versions, EntityManager.GetComponentData<PointCloudPlacement>(entity).Value))
                return;
            live.Versions = versions;
            EntityManager.AddComponentData(entity, StreamedOf(live.Versions));
            SetLook(entity, live.NextLook);
        }

        bool TryAdd(EntityCloud live, CloudVersions versions, CloudPlacement? placement)
        {
            try
            {
                versions.Add(live.NextSource, placement, live.NextStage);
                live.NextSource = null;
                return true;
            }
            catch (Exception e)
            {
                // Others' sources may throw anything: the next frame would try it again, and the clouds after it would wait.
                var failure = PointCloudException.Of(live.NextSource.Path, e);
                live.Error = failure.Message;
                Group.Stream.Report(new StreamFailure(live.NextSource.Path, -1, "cannot be shown: " + failure.FullMessage));
                live.DropSource();
                return false;
            }
        }

        void Follow(Entity entity, EntityCloud live)
        {
            var versions = live.Versions;
            var before = EntityManager.GetComponentData<StreamedPointCloud>(entity);
            int shown = before.Number;
            if (live.NextSource != null)
                TakeNext(entity, live);
            versions.Update();
            if (versions.ShownNumber != shown)
                Show(entity, live, shown);
            var placement = EntityManager.GetComponentData<PointCloudPlacement>(entity).Value;
            placement.Visibility = VisibilityOf(entity);
            versions.Place(placement);
            // A write completes the jobs of others that read it.
            var now = StreamedOf(versions);
            if (now.Number != before.Number || now.Preview != before.Preview || now.Next != before.Next)
                EntityManager.SetComponentData(entity, now);
        }

        CloudVisibility VisibilityOf(Entity entity)
        {
            var visibility = new CloudVisibility { IsHidden = EntityManager.HasComponent<Disabled>(entity) };
            if (!EntityManager.HasComponent<PointCloudLayer>(entity))
                return visibility;
            var layer = EntityManager.GetComponentData<PointCloudLayer>(entity);
            visibility.Layer = 1u << layer.Value;
            visibility.Scenes = layer.Scenes;
            visibility.IsHiddenInSceneViews = layer.IsHiddenInSceneViews;
            return visibility;
        }

        void TakeNext(Entity entity, EntityCloud live)
        {
            if (!TryAdd(live, live.Versions, null))
                return;
            if (live.NextLook.HasValue)
                live.Looks[live.Versions.Next] = live.NextLook.Value;
            else if (EntityManager.HasComponent<PointCloudLook>(entity))
                live.Looks[live.Versions.Next] = EntityManager.GetComponentData<PointCloudLook>(entity);
        }

        void Show(Entity entity, EntityCloud live, int before)
        {
            int shown = live.Versions.ShownNumber;
            if (live.Looks.TryGetValue(shown, out var look))
            {
                live.Looks.Remove(shown);
                if (EntityManager.HasComponent<PointCloudLook>(entity))
                    live.Looks[before] = EntityManager.GetComponentData<PointCloudLook>(entity);
                SetLook(entity, look);
            }
            EntityManager.SetComponentData(entity, new PointCloudPlacement { Value = Group.Stream.Clouds[shown].Placement });
        }

        void SetLook(Entity entity, PointCloudLook? look)
        {
            if (look.HasValue)
                EntityManager.AddComponentData(entity, look.Value);
        }

        static StreamedPointCloud StreamedOf(CloudVersions states) => new StreamedPointCloud
        {
            Number = states.ShownNumber,
            Preview = states.Preview,
            Next = states.Next,
        };

        void Remove(Entity entity, EntityCloud live)
        {
            live.Versions.Remove();
            live.Versions = null;
            live.Looks.Clear();
            // It may have been moved to another world.
            if (EntityManager.HasComponent<StreamedPointCloud>(entity))
                EntityManager.RemoveComponent<StreamedPointCloud>(entity);
        }

        /// <summary>Entities that came from another world or from a file do not stream what they streamed there.</summary>
        void ClearOwners()
        {
            using var entities = m_streamed.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
                if (Group.Live.Find(entity)?.Versions == null)
                    EntityManager.RemoveComponent<StreamedPointCloud>(entity);
        }
    }
}
