using System;
using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>What a cloud is streamed from: the stream takes it over in the next frame. A source that comes when there is one
    /// already is a newer state of the same cloud: it takes the place of the one before when it is there.</summary>
    public sealed class PointCloudSource : IComponentData, IDisposable
    {
        /// <summary>Null where it was taken.</summary>
        public NodeSource Source;

        /// <summary>How the source is coloured; the entity's <see cref="PointCloudLook"/> from when it is shown. Null where that
        /// stays as it is.</summary>
        public PointCloudLook? Look;

        public CloudStage Stage = CloudStage.Whole;

        /// <summary>What is shown of a build in progress goes: it was broken off.</summary>
        public bool WithdrawsBuild;

        /// <summary>What nobody took goes with the entity.</summary>
        public void Dispose()
        {
            Source?.Dispose();
            Source = null;
        }
    }
}
