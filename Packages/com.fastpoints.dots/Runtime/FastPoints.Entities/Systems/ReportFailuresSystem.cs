using Unity.Entities;
using UnityEngine;

namespace FastPoints.Entities
{
    /// <summary>Reports files and nodes that could not be read: each once, since permanent failures are not requested
    /// again.</summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PointCloudSystemGroup), OrderLast = true)]
    [UpdateAfter(typeof(TrackNodesSystem))]
    internal partial class ReportFailuresSystem : StreamSystem
    {
        protected override void OnUpdate()
        {
            while (Group.Stream.TryTakeFailure(out var failure))
                Debug.LogWarning("Point cloud: " + failure);
        }
    }
}
