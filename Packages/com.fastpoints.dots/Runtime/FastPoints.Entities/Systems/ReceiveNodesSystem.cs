using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Takes what arrived since the last frame.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    internal partial class ReceiveNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Receive(Group.Stream, ref Group.Stats);
    }
}
