using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Begins to copy nodes into the pool.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(SelectNodesSystem))]
    internal partial class UploadNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Upload(Group.Stream, ref Group.Stats);
    }
}
