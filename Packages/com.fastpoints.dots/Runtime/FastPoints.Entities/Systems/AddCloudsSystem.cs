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
        EntityQuery m_coming;
        EntityQuery m_streamed;
        EntityQuery m_leaving;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_coming = new EntityQueryBuilder(Allocator.Temp).WithAll<PointCloudPlacement>().WithAll<PointCloudSource>()
                .WithNone<StreamedPointCloud>().Build(this);
            m_streamed = new EntityQueryBuilder(Allocator.Temp).WithAll<PointCloudPlacement>().WithAll<StreamedPointCloud>()
                .WithOptions(EntityQueryOptions.IncludeDisabledEntities).Build(this);
            m_leaving = new EntityQueryBuilder(Allocator.Temp).WithAll<StreamedPointCloud>().WithNone<PointCloudPlacement>()
                .Build(this);
        }

        protected override void OnUpdate()
        {
            if (!m_leaving.IsEmpty)
                Remove();
            if (!m_coming.IsEmpty)
                Add();
            using var entities = m_streamed.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
                Follow(entity, EntityManager.GetComponentObject<PointCloudStates>(entity));
        }

        void Add()
        {
            using var entities = m_coming.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
            {
                var source = EntityManager.GetComponentObject<PointCloudSource>(entity);
                if (source.Source == null)
                    continue;
                var states = new PointCloudStates { Succession = new CloudSuccession(Group.Stream) };
                states.Succession.Add(source.Source, EntityManager.GetComponentData<PointCloudPlacement>(entity).Value,
                    source.Stage);
                source.Source = null;
                EntityManager.AddComponentData(entity, StreamedOf(states));
                EntityManager.AddComponentObject(entity, states);
                SetLook(entity, source.Look);
            }
        }

        void Follow(Entity entity, PointCloudStates states)
        {
            var succession = states.Succession;
            int shown = succession.Cloud;
            if (EntityManager.HasComponent<PointCloudSource>(entity))
                TakeNext(entity, EntityManager.GetComponentObject<PointCloudSource>(entity), states);
            succession.Update();
            if (succession.Cloud != shown)
                Show(entity, states, shown);
            var placement = EntityManager.GetComponentData<PointCloudPlacement>(entity).Value;
            placement.SeenBy = SeenBy(entity);
            succession.Place(placement);
            EntityManager.SetComponentData(entity, StreamedOf(states));
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

        void TakeNext(Entity entity, PointCloudSource source, PointCloudStates states)
        {
            if (source.WithdrawsBuild)
                states.Succession.Withdraw();
            source.WithdrawsBuild = false;
            if (source.Source == null)
                return;
            states.Succession.Add(source.Source, null, source.Stage);
            source.Source = null;
            if (source.Look.HasValue)
                states.Looks[states.Succession.Next] = source.Look.Value;
            else if (EntityManager.HasComponent<PointCloudLook>(entity))
                states.Looks[states.Succession.Next] = EntityManager.GetComponentData<PointCloudLook>(entity);
        }

        /// <summary>Shows another state from now on.</summary>
        /// <param name="before">The state shown so far, which may stay beside the new one.</param>
        void Show(Entity entity, PointCloudStates states, int before)
        {
            int shown = states.Succession.Cloud;
            if (states.Looks.TryGetValue(shown, out var look))
            {
                states.Looks.Remove(shown);
                if (EntityManager.HasComponent<PointCloudLook>(entity))
                    states.Looks[before] = EntityManager.GetComponentData<PointCloudLook>(entity);
                SetLook(entity, look);
            }
            EntityManager.SetComponentData(entity, new PointCloudPlacement { Value = Group.Stream.Clouds[shown].Placement });
        }

        void SetLook(Entity entity, PointCloudLook? look)
        {
            if (!look.HasValue)
                return;
            if (EntityManager.HasComponent<PointCloudLook>(entity))
                EntityManager.SetComponentData(entity, look.Value);
            else
                EntityManager.AddComponentData(entity, look.Value);
        }

        static StreamedPointCloud StreamedOf(PointCloudStates states) => new StreamedPointCloud
        {
            Number = states.Succession.Cloud,
            Beside = states.Succession.Beside,
            Next = states.Succession.Next,
        };

        void Remove()
        {
            using var entities = m_leaving.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
            {
                var leaving = EntityManager.GetComponentData<StreamedPointCloud>(entity);
                Group.Stream.Remove(leaving.Number);
                if (leaving.Beside != CloudSuccession.None)
                    Group.Stream.Remove(leaving.Beside);
                if (leaving.Next != CloudSuccession.None)
                    Group.Stream.Remove(leaving.Next);
                EntityManager.RemoveComponent<StreamedPointCloud>(entity);
            }
        }
    }
}
