using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Lists what to draw.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(RequestNodesSystem))]
    internal partial class ListNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.List(Group.Stream, ref Group.Stats);
    }
}
