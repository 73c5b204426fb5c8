using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    internal abstract partial class StreamSystem : SystemBase
    {
        protected PointCloudSystemGroup Group { get; private set; }

        protected override void OnCreate()
        {
            base.OnCreate();
            Group = World.GetOrCreateSystemManaged<PointCloudSystemGroup>();
        }
    }

    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    internal partial class ReceiveNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Receive(Group.Stream, ref Group.Stats);
    }
}
