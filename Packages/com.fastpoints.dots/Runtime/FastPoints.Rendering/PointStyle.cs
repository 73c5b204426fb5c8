using FastPoints.Drawing;

namespace FastPoints.Rendering
{
    /// <summary>How points look in a camera's picture.</summary>
    public struct PointStyle
    {
        public PointShape Shape;

        /// <summary>Size of points of every shape except pixels.</summary>
        public PointSize Size;

        /// <summary>Strength of eye-dome lighting: 0 turns it off at no cost; 0.25 is usual. It takes two more textures of the
        /// picture's size, 12 bytes a pixel and their depth, and one pass over them.</summary>
        public float EdlStrength;

        /// <summary>Fills a pixel without a point, most of whose neighbours have one. It uses the same layer.</summary>
        public bool FillsHoles;

        /// <summary>Points that are lit shade each other from the main light, where a compute shader can draw its depth map:
        /// 8 MiB and a pass over what the light sees.</summary>
        public bool Shadows;

        /// <summary>A picture of more points is drawn over several frames: each draws those that were visible in the last one,
        /// then as many others as fit, until the picture is that of all points. Of each camera, and each eye. 0 draws all points
        /// in every frame, as splats always are.</summary>
        public int PointsPerFrame;

        /// <summary>Milliseconds that the GPU may take for a frame: <see cref="PointsPerFrame"/> then is where the number begins
        /// that meets them, in players with Frame Timing Stats (Project Settings, Player). 0 leaves it as it is.</summary>
        public float GpuFrameMs;

        // Points of a listed cloud are lit: see CloudLook.Light.
        internal bool IsLit;
        internal bool IsShadowed;

        internal readonly bool IsProgressive => PointsPerFrame > 0 && !IsBlended;

        // Into a layer of their own first.
        internal readonly bool IsLayered => EdlStrength > 0 || FillsHoles || IsLit || IsBlended || IsProgressive;
        internal readonly bool IsBlended => Shape == PointShape.Splat; // A second time to be summed.

        // In the size tree.
        internal readonly bool IsAdaptive => Shape != PointShape.Pixel && Size.Mode == PointSizeMode.Adaptive;

        public static PointStyle Default => new PointStyle { Shape = PointShape.Square, Size = PointSize.Pixels(2) };
    }

    /// <summary>The shape that a point is drawn as.</summary>
    public enum PointShape
    {
        /// <summary>The fastest shape for dense points. A compute shader draws it where the device supports that.</summary>
        Pixel,

        /// <summary>A square that faces the camera.</summary>
        Square,

        /// <summary>A disc that faces the camera.</summary>
        Disc,

        /// <summary>A disc that bulges towards the camera. Each pixel of overlapping points goes to the nearest centre, which
        /// keeps detail that flat discs hide. Writing the fragment's own depth disables the GPU's early depth test.</summary>
        Paraboloid,

        /// <summary>A disc that is blended with those at most its diameter behind it, with weights that fall towards the rim: the
        /// smoothest shape, without the noise of points that overlap by chance. Points are drawn twice, into a layer of 32 bytes
        /// a pixel.</summary>
        Splat,
    }
}
