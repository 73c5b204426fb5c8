using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The cloud is in the stream. When its entity is destroyed this stays until the stream has let it go.</summary>
    public struct StreamedPointCloud : ICleanupComponentData
    {
        /// <summary>Of the cloud in the stream (<see cref="StreamContext.Clouds"/>). Another one when a newer state of the cloud
        /// has taken its place.</summary>
        public int Number;

        /// <summary>Of a preview that is shown beside a build in progress; <see cref="CloudSuccession.None"/> for none.</summary>
        public int Beside;

        /// <summary>Of a newer state that is on its way; <see cref="CloudSuccession.None"/> for none.</summary>
        public int Next;
    }
}
