using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The states of a cloud that are in the stream.</summary>
    public sealed class PointCloudStates : IComponentData
    {
        public CloudSuccession Succession;

        /// <summary>By number in the stream: how <see cref="StreamedPointCloud.Beside"/> and
        /// <see cref="StreamedPointCloud.Next"/> are coloured; the entity's own look is that of what is shown.</summary>
        public readonly Dictionary<int, PointCloudLook> Looks = new Dictionary<int, PointCloudLook>();
    }
}
