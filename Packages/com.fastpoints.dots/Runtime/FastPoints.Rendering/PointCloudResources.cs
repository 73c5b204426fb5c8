using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>Refers to the package's shaders, so that builds keep them.</summary>
    [HelpPage("internals/rendering")]
    public sealed class PointCloudResources : ScriptableObject
    {
        /// <summary>Below any Resources folder.</summary>
        public const string Path = "FastPoints/PointCloudResources";

        public Shader Points;
        public Shader Compose;
        public ComputeShader CopyPages;
        public ComputeShader Raster;
        public ComputeShader Progressive;
        public ComputeShader Gather;

        public static PointCloudResources Load() => Resources.Load<PointCloudResources>(Path);
    }
}
