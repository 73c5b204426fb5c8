using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The states of a cloud that are in the stream.</summary>
    public sealed class PointCloudStates : IComponentData
    {
        public CloudSuccession Succession;

        /// <summary>How <see cref="StreamedPointCloud.Beside"/> and <see cref="StreamedPointCloud.Next"/> are coloured, by their
        /// number in the stream. The entity's own look is that of the shown state.</summary>
        public readonly Dictionary<int, PointCloudLook> Looks = new Dictionary<int, PointCloudLook>();
    }
}
