using System.Collections.Generic;

namespace FastPoints.Rendering
{
    /// <summary>A variant of the package's Points.shader: the keywords that a draw needs.</summary>
    internal readonly struct PointVariant
    {
        /// <summary>Range of <see cref="Number"/>; no draw needs all of them.</summary>
        internal const int Count = Shapes << 5;

        const int Shapes = 1 + (int)PointShape.Paraboloid;

        /// <summary>Keyword of each shape; pixels have none.</summary>
        static readonly string[] s_shapes =
        {
            null, ShaderNames.SquaresKeyword, ShaderNames.DiscsKeyword, ShaderNames.ParaboloidsKeyword,
        };

        /// <summary>Keyword of each option bit.</summary>
        static readonly string[] s_options =
        {
            ShaderNames.AdaptiveKeyword, ShaderNames.LayeredKeyword, ShaderNames.ClippedKeyword, ShaderNames.FilteredKeyword,
            ShaderNames.StereoKeyword,
        };

        readonly int m_shape;

        /// <summary>Each bit is an index in <see cref="s_options"/>.</summary>
        readonly int m_options;

        /// <param name="style">Splats are drawn as discs, into a layer.</param>
        /// <param name="isClipped">Whether there are clip boxes.</param>
        /// <param name="isFiltered">Whether classes are hidden.</param>
        /// <param name="isStereo">Whether both eyes are drawn at once; styles with a layer draw them one after the other.</param>
        public PointVariant(in PointStyle style, bool isClipped, bool isFiltered, bool isStereo)
        {
            m_shape = (int)(style.IsBlended ? PointShape.Disc : style.Shape);
            m_options = (style.IsAdaptive ? 1 : 0) | (style.IsLayered ? 2 : 0) | (isClipped ? 4 : 0) | (isFiltered ? 8 : 0) |
                (isStereo && !style.IsLayered ? 16 : 0);
        }

        PointVariant(int shape, int options)
        {
            m_shape = shape;
            m_options = options;
        }

        /// <summary>From 0 to <see cref="Count"/> - 1.</summary>
        internal int Number => m_shape + Shapes * m_options;

        /// <summary>The variant for the pass that sums splats.</summary>
        public PointVariant Blending => new PointVariant(0, m_options & ~2);

        /// <summary>The enabled keywords.</summary>
        public IEnumerable<string> Keywords
        {
            get
            {
                if (s_shapes[m_shape] != null)
                    yield return s_shapes[m_shape];
                for (int option = 0; option < s_options.Length; option++)
                    if ((m_options >> option & 1) != 0)
                        yield return s_options[option];
            }
        }

        /// <summary>The keyword of the package's Compose.shader that a style needs; null for its plain variant, and for styles
        /// that compose nothing.</summary>
        public static string ComposeKeyword(in PointStyle style) => style.IsBlended ? ShaderNames.BlendedKeyword
            : style.Shape == PointShape.Pixel && !style.IsLayered ? ShaderNames.FromPixelsKeyword : null;
    }
}
