using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>A converted cloud of the project.</summary>
    public sealed class CatalogCloud
    {
        /// <summary>Its folder: a whole path, under the name that it has when it is finished.</summary>
        public string Path;

        /// <summary>Null where <see cref="Problem"/> says why.</summary>
        public CloudManifest Manifest;

        /// <summary>Why it cannot be used, in one line; null where it can.</summary>
        public string Problem;

        /// <summary>It is not finished: a build goes on, or was broken off.</summary>
        public bool IsBuilding;

        public string Name => System.IO.Path.GetFileNameWithoutExtension(Path);
    }
}
