using FastPoints.Streaming;
using Unity.Entities;

// The steps of FrameStep after ControlNodesSystem, in their order.
namespace FastPoints.Entities
{
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(ControlNodesSystem))]
    internal partial class SelectNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Select(Group.Stream, Group.Views.AsArray(), ref Group.Stats);
    }

    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(SelectNodesSystem))]
    internal partial class UploadNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Upload(Group.Stream, ref Group.Stats);
    }

    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(UploadNodesSystem))]
    internal partial class RequestNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.Request(Group.Stream, ref Group.Stats);
    }

    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup))]
    [UpdateAfter(typeof(RequestNodesSystem))]
    internal partial class ListNodesSystem : StreamSystem
    {
        protected override void OnUpdate() => FrameStep.List(Group.Stream, ref Group.Stats);
    }
}
