using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>What a <see cref="ComputeRaster"/> reads of one camera's draws.</summary>
    struct RasterBuffers
    {
        public GraphicsBuffer Nodes;
        public GraphicsBuffer Clouds;
        public GraphicsBuffer NodeOfInstance;
        public GraphicsBuffer Palettes;

        /// <summary>Null where there are none.</summary>
        public GraphicsBuffer ClipBoxes;
    }
}
