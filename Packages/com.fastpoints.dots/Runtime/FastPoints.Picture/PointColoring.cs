using FastPoints.Drawing;

namespace FastPoints.Picture
{
    internal static unsafe class PointColoring
    {
        public static void ColorBatch(byte* bytes, int first, in ColorMapping mapping, uint* palettes, in PointSpan span)
        {
            int count = span.Count;
            uint* colors = span.Colors;
            double* values = stackalloc double[ColumnValues.BatchLength];
            if (mapping.Mode == ColorMode.Rgb)
            {
                for (int i = 0; i < count; i++)
                    colors[i] = 0xFF000000u;
                for (int channel = 0; channel < 3; channel++)
                {
                    var column = channel == 0 ? mapping.First : channel == 1 ? mapping.Second : mapping.Third;
                    ColumnValues.ToDoubles(bytes + column.OffsetBytes, column.Type, first, count, values);
                    for (int i = 0; i < count; i++)
                        colors[i] |= (uint)ToIndex(values[i] * mapping.Scale + mapping.Bias) << 8 * channel;
                }
                return;
            }
            if (mapping.Mode == ColorMode.Elevation)
            {
                var weights = mapping.PositionWeights;
                for (int i = 0; i < count; i++)
                    values[i] = span.X[i] * weights.x + span.Y[i] * weights.y + span.Z[i] * weights.z;
                Lookup(values, count, mapping, palettes, colors);
                return;
            }
            ColumnValues.ToDoubles(bytes + mapping.First.OffsetBytes, mapping.First.Type, first, count, values);
            Lookup(values, count, mapping, palettes, colors);
        }

        static void Lookup(double* values, int count, in ColorMapping mapping, uint* palettes, uint* colors)
        {
            uint* palette = palettes + mapping.FirstEntry;
            for (int i = 0; i < count; i++)
            {
                double entry = values[i] * mapping.Scale + mapping.Bias;
                colors[i] = palette[mapping.Wraps ? (int)((long)entry & (Palettes.Length - 1)) : ToIndex(entry)];
            }
        }

        // NaN becomes 0.
        static int ToIndex(double value) => !(value > 0) ? 0 : value < 255 ? (int)value : 255;
    }
    // At most ColumnValues.BatchLength consecutive points: their stored coordinates, and their colours.
    internal unsafe struct PointSpan
    {
        public int Count;
        public double* X;
        public double* Y;
        public double* Z;
        public uint* Colors;
    }
}
