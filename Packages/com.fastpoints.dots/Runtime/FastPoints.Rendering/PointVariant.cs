using System.Collections.Generic;

namespace FastPoints.Rendering
{
    // A variant of Points.shader: the keywords that a draw needs.
    internal readonly struct PointVariant
    {
        internal const int Count = Shapes << 5; // Range of Number; no draw needs all of them.

        const int Shapes = 1 + (int)PointShape.Paraboloid;

        // Pixels have none.
        static readonly string[] s_shapes =
        {
            null, ShaderNames.SquaresKeyword, ShaderNames.DiscsKeyword, ShaderNames.ParaboloidsKeyword,
        };

        static readonly string[] s_options =
        {
            ShaderNames.AdaptiveKeyword, ShaderNames.LayeredKeyword, ShaderNames.ClippedKeyword, ShaderNames.FilteredKeyword,
            ShaderNames.StereoKeyword,
        };

        readonly int m_shape;
        readonly int m_options; // Each bit is an index in s_options.

        // Splats are drawn as discs, into a layer; styles with a layer draw both eyes one after the other. Progressive pictures'
        // pass has shapes and adaptive sizes alone.
        public PointVariant(in PointStyle style, bool isClipped, bool isFiltered, bool isStereo)
        {
            m_shape = (int)(style.IsBlended ? PointShape.Disc : style.Shape);
            m_options = style.IsAdaptive ? 1 : 0;
            if (!style.IsProgressive)
                m_options |= (style.IsLayered ? 2 : 0) | (isClipped ? 4 : 0) | (isFiltered ? 8 : 0) |
                    (isStereo && !style.IsLayered ? 16 : 0);
        }

        internal int Number => m_shape + Shapes * m_options;

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
    }
}
