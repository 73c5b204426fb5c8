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
        readonly List<Entity> m_gone = new List<Entity>();
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
                bool isThere = EntityManager.HasComponent<PointCloudPlacement>(entity) &&
                    !EntityManager.HasComponent<Prefab>(entity);
                if (live.Succession != null && !(isThere && EntityManager.HasComponent<StreamedPointCloud>(entity)))
                    Remove(entity, live);
                else if (live.Source != null && isThere && live.Succession == null &&
                    !EntityManager.HasComponent<Disabled>(entity))
                    Add(entity, live);
                if (live.Succession != null)
                    Follow(entity, live);
                else if (!EntityManager.Exists(entity))
                    m_gone.Add(entity);
                streamed += live.Succession != null ? 1 : 0;
            }
            foreach (var entity in m_gone)
                Group.Live.Remove(entity);
            m_gone.Clear();
            if (m_streamed.CalculateEntityCount() != streamed)
                Disown();
        }

        void Add(Entity entity, LiveCloud live)
        {
            live.Succession = new CloudSuccession(Group.Stream);
            live.Succession.Add(live.Source, EntityManager.GetComponentData<PointCloudPlacement>(entity).Value, live.Stage);
            live.Source = null;
            EntityManager.AddComponentData(entity, StreamedOf(live.Succession));
            SetLook(entity, live.Look);
        }

        void Follow(Entity entity, LiveCloud live)
        {
            var succession = live.Succession;
            int shown = EntityManager.GetComponentData<StreamedPointCloud>(entity).Number;
            if (live.Source != null)
                TakeNext(entity, live);
            succession.Update();
            if (succession.Cloud != shown)
                Show(entity, live, shown);
            var placement = EntityManager.GetComponentData<PointCloudPlacement>(entity).Value;
            placement.SeenBy = SeenBy(entity);
            succession.Place(placement);
            EntityManager.SetComponentData(entity, StreamedOf(succession));
        }

        CloudVisibility SeenBy(Entity entity)
        {
            var seen = new CloudVisibility { IsHidden = EntityManager.HasComponent<Disabled>(entity) };
            if (!EntityManager.HasComponent<PointCloudLayer>(entity))
                return seen;
            var layer = EntityManager.GetComponentData<PointCloudLayer>(entity);
            seen.Layer = 1u << layer.Value;
            seen.Scenes = layer.Scenes;
            seen.IsHiddenInSceneViews = layer.IsHiddenInSceneViews;
            return seen;
        }

        void TakeNext(Entity entity, LiveCloud live)
        {
            live.Succession.Add(live.Source, null, live.Stage);
            live.Source = null;
            if (live.Look.HasValue)
                live.Looks[live.Succession.Next] = live.Look.Value;
            else if (EntityManager.HasComponent<PointCloudLook>(entity))
                live.Looks[live.Succession.Next] = EntityManager.GetComponentData<PointCloudLook>(entity);
        }

        /// <summary>Shows another state from now on.</summary>
        /// <param name="before">The state shown so far, which may stay beside the new one.</param>
        void Show(Entity entity, LiveCloud live, int before)
        {
            int shown = live.Succession.Cloud;
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

        static StreamedPointCloud StreamedOf(CloudSuccession states) => new StreamedPointCloud
        {
            Number = states.Cloud,
            Beside = states.Beside,
            Next = states.Next,
        };

        void Remove(Entity entity, LiveCloud live)
        {
            live.Succession.Remove();
            live.Succession = null;
            live.Looks.Clear();
            // It may be gone without a trace, to another world.
            if (EntityManager.HasComponent<StreamedPointCloud>(entity))
                EntityManager.RemoveComponent<StreamedPointCloud>(entity);
        }

        /// <summary>Entities that came from another world or from a file do not stream what they streamed there.</summary>
        void Disown()
        {
            using var entities = m_streamed.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
                if (Group.Live.Find(entity)?.Succession == null)
                    EntityManager.RemoveComponent<StreamedPointCloud>(entity);
        }
    }
}
