using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The cloud is in the stream. When its entity is destroyed this stays until the stream has let it go.</summary>
    public struct StreamedPointCloud : ICleanupComponentData
    {
        /// <summary>Of the cloud in the stream (<see cref="Streaming.StreamContext.Clouds"/>).</summary>
        public int Number;
    }
}
