using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;

namespace FastPoints.Entities
{
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderFirst = true)]
    [UpdateAfter(typeof(OpenCloudsSystem))]
    [UpdateBefore(typeof(AddCloudsSystem))]
    internal partial class PlaceCloudsSystem : StreamSystem
    {
        EntityQuery m_placed;

        protected override void OnCreate()
        {
            base.OnCreate();
            m_placed = new EntityQueryBuilder(Allocator.Temp).WithAll<LocalToWorld>().WithAll<PointCloudSpace>()
                .WithAll<PointCloudPlacement>().Build(this);
        }

        protected override void OnUpdate()
        {
            using var entities = m_placed.ToEntityArray(Allocator.Temp);
            foreach (var entity in entities)
            {
                var live = Group.Live.Find(entity);
                var source = live?.Versions == null ? live?.NextSource : Group.Stream.Clouds[live.Versions.ShownNumber].Source;
                if (source == null)
                    continue;
                var localToWorld = new double4x4(EntityManager.GetComponentData<LocalToWorld>(entity).Value);
                var space = EntityManager.GetComponentData<PointCloudSpace>(entity).Value;
                var placed = space.Place(source.Grid, source.Root, localToWorld);
                var before = EntityManager.GetComponentData<PointCloudPlacement>(entity).Value;
                if (!placed.Linear.Equals(before.Linear) || !placed.OriginWorld.Equals(before.OriginWorld))
                    EntityManager.SetComponentData(entity, new PointCloudPlacement { Value = placed });
            }
        }
    }
}
