using Unity.Collections;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Clouds whose entities came go into the stream, those whose entities are gone leave it; placements
    /// follow.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    public partial class AddCloudsSystem : StreamSystem
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
                .Build(this);
            m_leaving = new EntityQueryBuilder(Allocator.Temp).WithAll<StreamedPointCloud>().WithNone<PointCloudPlacement>()
                .Build(this);
        }

        protected override void OnUpdate()
        {
            if (!m_leaving.IsEmpty)
                Remove();
            if (!m_coming.IsEmpty)
                Add();
            using (var entities = m_streamed.ToEntityArray(Allocator.Temp))
                foreach (var entity in entities)
                    Group.Stream.Clouds[EntityManager.GetComponentData<StreamedPointCloud>(entity).Number].Placement =
                        EntityManager.GetComponentData<PointCloudPlacement>(entity).Value;
        }

        void Add()
        {
            using (var entities = m_coming.ToEntityArray(Allocator.Temp))
                foreach (var entity in entities)
                {
                    var source = EntityManager.GetComponentObject<PointCloudSource>(entity);
                    if (source.Source == null)
                        continue;
                    var placement = EntityManager.GetComponentData<PointCloudPlacement>(entity).Value;
                    int number = Group.Stream.Add(source.Source, placement);
                    source.Source = null;
                    EntityManager.AddComponentData(entity, new StreamedPointCloud { Number = number });
                }
        }

        void Remove()
        {
            using (var entities = m_leaving.ToEntityArray(Allocator.Temp))
                foreach (var entity in entities)
                {
                    Group.Stream.Remove(EntityManager.GetComponentData<StreamedPointCloud>(entity).Number);
                    EntityManager.RemoveComponent<StreamedPointCloud>(entity);
                }
        }
    }
}
