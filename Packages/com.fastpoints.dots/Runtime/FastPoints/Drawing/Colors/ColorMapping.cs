using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Maps a point's stored values to its colour, for one batch layout.
    internal struct ColorMapping
    {
        public ColorMode Mode; // Never Auto.
        public PointColumn First; // Three columns for RGB; modes of one attribute have the first alone.
        public PointColumn Second;
        public PointColumn Third;
        public int FirstEntry; // Of its table in Palettes.CreateAll; meaningless for RGB.
        public bool Wraps; // Entries beyond 255 count from 0 again.
        public double Scale; // Byte (or palette entry) = floor(value * Scale + Bias), clamped to 0 to 255.
        public double Bias;
        public double3 PositionWeights; // For elevation: weights of the stored x, y and z in the value; otherwise 0.

        // For a mode that the batch has the columns for (DisplayRanges.Resolve).
        public static ColorMapping For(ColorMode mode, DisplayRanges ranges, PointBatch batch, in PositionTransform transform,
            ColorRamp ramp = ColorRamp.Auto)
        {
            var mapping = Of(mode, ranges, transform, ramp);
            var schema = batch.Schema;
            if (ranges.AttributeOf(mode) is string attribute)
                mapping.First = batch.Column(schema.IndexOf(attribute));
            if (mode != ColorMode.Rgb)
                return mapping;
            mapping.First = batch.Column(schema.IndexOf(AttributeNames.Red));
            mapping.Second = batch.Column(schema.IndexOf(AttributeNames.Green));
            mapping.Third = batch.Column(schema.IndexOf(AttributeNames.Blue));
            return mapping;
        }

        // Without columns.
        public static ColorMapping Of(ColorMode mode, DisplayRanges ranges, in PositionTransform transform,
            ColorRamp ramp = ColorRamp.Auto)
        {
            var mapping = new ColorMapping { Mode = mode, FirstEntry = Palettes.Length * Palettes.IndexOf(mode, ramp) };
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

        // A single value maps to the middle.
        void SetRange(double low, double high)
        {
            double extent = high - low;
            bool varies = extent > 0 && extent <= double.MaxValue;
            Scale = varies ? (Palettes.Length - 1) / extent : 0;
            Bias = varies ? 0.5 - low * Scale : Palettes.Length / 2;
        }
    }
}
