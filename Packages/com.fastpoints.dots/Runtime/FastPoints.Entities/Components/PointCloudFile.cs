using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>A converted cloud on disk: an entity with this, and a transform, is opened and streamed.</summary>
    public sealed class PointCloudFile : IComponentData
    {
        /// <summary>Of the <c>.fastpoints</c> folder: absolute, or below the application's streaming assets.</summary>
        public string Path;

        /// <summary>What went wrong when it was opened; null where nothing did.</summary>
        public string Error;
    }
}
