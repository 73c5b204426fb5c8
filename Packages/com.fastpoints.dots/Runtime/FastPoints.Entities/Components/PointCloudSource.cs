using System;
using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The source that a cloud is streamed from; the stream takes it over in the next frame. If there is one already,
    /// the new source is a newer state of the same cloud and replaces it when it is ready.</summary>
    public sealed class PointCloudSource : IComponentData, IDisposable
    {
        /// <summary>Null if it was taken.</summary>
        public NodeSource Source;

        /// <summary>How the source is coloured, which becomes the entity's <see cref="PointCloudLook"/> when it is shown. Null
        /// keeps the current look.</summary>
        public PointCloudLook? Look;

        public CloudStage Stage = CloudStage.Whole;

        /// <summary>Whether the shown build in progress is withdrawn, because it was broken off.</summary>
        public bool WithdrawsBuild;

        /// <summary>Disposes, with the entity, what nobody took.</summary>
        public void Dispose()
        {
            Source?.Dispose();
            Source = null;
        }
    }
}
