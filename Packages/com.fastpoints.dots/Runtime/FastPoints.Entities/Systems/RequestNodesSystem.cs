using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Begins to read nodes, and evicts less useful ones.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(UploadNodesSystem))]
    internal partial class RequestNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Request(Group.Stream, ref Group.Stats);
    }
}
