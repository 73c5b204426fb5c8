using Unity.Burst.Intrinsics;

namespace FastPoints.HostTests.Probes;

public struct Health : IComponentData
{
    public int Value;
}

public struct DamageAllJob : IJobChunk
{
    public ComponentTypeHandle<Health> Health;

    public void Execute(in ArchetypeChunk chunk, int unfilteredChunkIndex, bool useEnabledMask, in v128 chunkEnabledMask)
    {
        var values = chunk.GetNativeArray(ref Health);
        for (int i = 0; i < chunk.Count; i++)
            values[i] = new Health { Value = values[i].Value + 1 };
    }
}

public struct TintAll : IJobChunk
{
    public ComponentTypeHandle<Tint> Tint;
    public ComponentTypeHandle<Hidden> Hidden;
    [ReadOnly] public ComponentTypeHandle<PointCloudNode> Node;
    public int Frame;

    public void Execute(in ArchetypeChunk chunk, int unfilteredChunkIndex, bool useEnabledMask, in v128 chunkEnabledMask)
    {
        var tints = chunk.GetNativeArray(ref Tint);
        var nodes = chunk.GetNativeArray(ref Node);
        for (int i = 0; i < chunk.Count; i++)
        {
            tints[i] = new Tint { Rgba = (uint)(nodes[i].PointCount * 77 + Frame) };
            chunk.SetComponentEnabled(ref Tint, i, (i + Frame) % 2 == 0);
            chunk.SetComponentEnabled(ref Hidden, i, (i + Frame) % 3 == 0);
        }
    }
}

[DisableAutoCreation]
[UpdateInGroup(typeof(SimulationSystemGroup))]
public sealed partial class TintSystem : SystemBase
{
    EntityQuery m_nodes;
    int m_frame;

    internal int Scheduled { get; private set; }

    protected override void OnCreate() =>
        m_nodes = new EntityQueryBuilder(Allocator.Temp).WithPresent<Tint, Hidden>()
            .WithAll<PointCloudNode>().Build(this);

    protected override void OnUpdate()
    {
        Scheduled += m_nodes.CalculateEntityCount();
        Dependency = new TintAll
        {
            Tint = GetComponentTypeHandle<Tint>(),
            Hidden = GetComponentTypeHandle<Hidden>(),
            Node = GetComponentTypeHandle<PointCloudNode>(true),
            Frame = m_frame++,
        }.ScheduleParallel(m_nodes, Dependency);
    }
}
