using System;
using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>What a cloud is streamed from: the stream takes it over in the next frame.</summary>
    public sealed class PointCloudSource : IComponentData, IDisposable
    {
        /// <summary>Null where it was taken.</summary>
        public NodeSource Source;

        /// <summary>What nobody took goes with the entity.</summary>
        public void Dispose()
        {
            Source?.Dispose();
            Source = null;
        }
    }
}
