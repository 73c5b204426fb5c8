using System.Collections.Generic;

namespace FastPoints.Rendering
{
    /// <summary>A variant of the package's Points.shader: the keywords that a draw needs.</summary>
    internal readonly struct PointVariant
    {
        /// <summary>Numbers that variants have; no draw needs all of them.</summary>
        internal const int Count = Shapes << 5;

        const int Shapes = 1 + (int)PointShape.Paraboloid;

        /// <summary>By shape; pixels have none.</summary>
        static readonly string[] s_shapes =
        {
            null, ShaderNames.SquaresKeyword, ShaderNames.DiscsKeyword, ShaderNames.ParaboloidsKeyword,
        };

        /// <summary>Of the options, by bit.</summary>
        static readonly string[] s_options =
        {
            ShaderNames.AdaptiveKeyword, ShaderNames.LayeredKeyword, ShaderNames.ClippedKeyword, ShaderNames.FilteredKeyword,
            ShaderNames.StereoKeyword,
        };

        readonly int m_shape;

        /// <summary>Bits: places in <see cref="s_options"/>.</summary>
        readonly int m_options;

        /// <param name="style">Splats are drawn as discs, into a layer.</param>
        /// <param name="isClipped">There are clip boxes.</param>
        /// <param name="isFiltered">Classes are hidden.</param>
        /// <param name="isStereo">Both eyes at once; styles with a layer draw one after the other.</param>
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

        /// <summary>What the pass that adds splats up needs of it.</summary>
        public PointVariant Blending => new PointVariant(0, m_options & ~2);

        /// <summary>Those that are enabled.</summary>
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

        /// <summary>The keyword of the package's Compose.shader that a style needs; null for its plain variant, or none of
        /// it.</summary>
        public static string ComposeKeyword(in PointStyle style) => style.IsBlended ? ShaderNames.BlendedKeyword
            : style.Shape == PointShape.Pixel && !style.IsLayered ? ShaderNames.FromPixelsKeyword
            : null;
    }
}
