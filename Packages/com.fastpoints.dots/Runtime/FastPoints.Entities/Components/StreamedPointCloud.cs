using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The cloud is in the stream. When its entity is destroyed, this stays until the stream has released the
    /// cloud.</summary>
    public struct StreamedPointCloud : ICleanupComponentData
    {
        /// <summary>Number of the cloud in the stream (<see cref="StreamContext.Clouds"/>). It changes when a newer state of the
        /// cloud replaces it.</summary>
        public int Number;

        /// <summary>Number of a preview that is shown beside a build in progress; -1 for none.</summary>
        public int Preview;

        /// <summary>Number of a newer state that is being loaded; -1 for none.</summary>
        public int Next;
    }
}
