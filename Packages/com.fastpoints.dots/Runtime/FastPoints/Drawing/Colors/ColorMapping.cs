using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>Maps a point's stored values to its colour, for one batch layout. Blittable, for jobs.</summary>
    internal struct ColorMapping
    {
        /// <summary>The mode, which is never <see cref="ColorMode.Auto"/>.</summary>
        public ColorMode Mode;

        /// <summary>The three columns for RGB; for modes of one attribute, the first one is its column.</summary>
        public PointColumn First;
        public PointColumn Second;
        public PointColumn Third;

        /// <summary>The first entry of its table among all (<see cref="Palettes.CreateAll"/>); meaningless for RGB.</summary>
        public int FirstEntry;

        /// <summary>Whether the palette repeats: entries beyond 255 count from 0 again.</summary>
        public bool Wraps;

        /// <summary>Byte (or palette entry) = floor(value * Scale + Bias), clamped to 0 to 255.</summary>
        public double Scale;
        public double Bias;

        /// <summary>For elevation: weights of the stored x, y and z in the value; otherwise 0.</summary>
        public double3 PositionWeights;

        /// <summary>The mapping for a mode that the batch has the columns for (see
        /// <see cref="DisplayRanges.Resolve"/>).</summary>
        /// <param name="gradient">The gradient for amounts.</param>
        public static ColorMapping For(ColorMode mode, DisplayRanges ranges, PointBatch batch, in PositionTransform transform,
            Gradient gradient = Gradient.Auto)
        {
            var mapping = Of(mode, ranges, transform, gradient);
            var schema = batch.Schema;
            switch (mode)
            {
                case ColorMode.Rgb:
                    mapping.First = batch.Column(schema.IndexOf(AttributeNames.Red));
                    mapping.Second = batch.Column(schema.IndexOf(AttributeNames.Green));
                    mapping.Third = batch.Column(schema.IndexOf(AttributeNames.Blue));
                    break;
                default:
                    if (ColorModes.AttributeOf(mode) is string attribute)
                        mapping.First = batch.Column(schema.IndexOf(attribute));
                    break;
            }
            return mapping;
        }

        /// <summary>The mapping for a mode, without columns.</summary>
        /// <param name="gradient">The gradient for amounts.</param>
        public static ColorMapping Of(ColorMode mode, DisplayRanges ranges, in PositionTransform transform,
            Gradient gradient = Gradient.Auto)
        {
            var mapping = new ColorMapping { Mode = mode, FirstEntry = Palettes.Length * Palettes.IndexOf(mode, gradient) };
            switch (mode)
            {
                case ColorMode.Rgb:
                    mapping.Scale = ranges.Color == ColorDepth.Unit ? 255 : ranges.Color == ColorDepth.Bits16 ? 1 / 256.0 : 1;
                    mapping.Bias = ranges.Color == ColorDepth.Unit ? 0.5 : 0;
                    break;
                case ColorMode.Intensity:
                    mapping.SetRange(ranges.IntensityLow, ranges.IntensityHigh);
                    break;
                case ColorMode.Classification:
                case ColorMode.ReturnNumber:
                    mapping.Scale = 1;
                    break;
                case ColorMode.PointSource:
                    mapping.Scale = 1;
                    mapping.Wraps = true;
                    break;
                default:
                    int axis = ranges.UpAxis.Index();
                    double sign = ranges.UpAxis.IsNegative() ? -1 : 1;
                    mapping.SetRange(ranges.ElevationLow, ranges.ElevationHigh);
                    mapping.Bias += sign * transform.Offset[axis] * mapping.Scale;
                    var weights = new double3(0, 0, 0);
                    weights[axis] = sign * transform.Scale[axis];
                    mapping.PositionWeights = weights;
                    break;
            }
            return mapping;
        }

        /// <summary>Maps low to entry 0 and high to entry 255; a single value maps to the middle.</summary>
        void SetRange(double low, double high)
        {
            double extent = high - low;
            bool varies = extent > 0 && extent <= double.MaxValue;
            Scale = varies ? (Palettes.Length - 1) / extent : 0;
            Bias = varies ? 0.5 - low * Scale : Palettes.Length / 2;
        }
    }
}
