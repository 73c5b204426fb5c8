using FastPoints.Gpu;

namespace FastPoints.Rendering
{
    /// <summary>What points look like in a camera's picture.</summary>
    public struct PointStyle
    {
        public PointShape Shape;

        /// <summary>Of all but pixels.</summary>
        public PointSize Size;

        /// <summary>Strength of eye-dome lighting: 0 for none, which costs nothing; 0.25 is usual. It takes two more textures of
        /// the picture's size, 12 bytes a pixel and their depth, and one pass over them.</summary>
        public float EdlStrength;

        /// <summary>A pixel without a point, most of whose neighbours have one, gets their mean. It takes the same
        /// layer.</summary>
        public bool FillsHoles;

        /// <summary>Whether points are drawn into a layer of their own first.</summary>
        internal readonly bool IsLayered => EdlStrength > 0 || FillsHoles || IsBlended;

        /// <summary>Whether points are drawn a second time, to be added up.</summary>
        internal readonly bool IsBlended => Shape == PointShape.Splat;

        /// <summary>Whether sizes are looked up.</summary>
        internal readonly bool IsAdaptive => Shape != PointShape.Pixel && Size.Mode == PointSizeMode.Adaptive;

        public static PointStyle Default => new PointStyle { Shape = PointShape.Square, Size = PointSize.Pixels(2) };
    }
}
