using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Chooses what the cameras need, and what they will need soon.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(ControlNodesSystem))]
    internal partial class SelectNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Select(Group.Stream, Group.Views.AsArray(), ref Group.Stats);
    }
}
