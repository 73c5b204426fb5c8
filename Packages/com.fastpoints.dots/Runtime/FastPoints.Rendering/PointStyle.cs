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

    /// <summary>What a point is drawn as.</summary>
    public enum PointShape
    {
        /// <summary>The pixel that it lies in: the fastest where points are dense. By a compute shader where the device has
        /// them.</summary>
        Pixel,

        /// <summary>A square that faces the camera.</summary>
        Square,

        /// <summary>A disc that faces the camera.</summary>
        Disc,

        /// <summary>A disc that bulges towards the camera: points share a pixel by which of them is nearer to its centre, which
        /// keeps detail that overlapping discs hide. The fragment's own depth costs the card its early test.</summary>
        Paraboloid,

        /// <summary>A disc that is blended with those that lie at most its diameter behind it, with weights that fall towards the
        /// rim: the smoothest, and without the noise of points that overlap by chance. Points are drawn twice, into a layer of 32
        /// bytes a pixel.</summary>
        Splat,
    }
}
