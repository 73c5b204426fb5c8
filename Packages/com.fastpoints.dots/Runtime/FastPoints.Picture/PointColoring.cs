using FastPoints.Core;
using FastPoints.Drawing;

namespace FastPoints.Picture
{
    internal static unsafe class PointColoring
    {
        // At most ColumnValues.RunLength points, whose stored coordinates are given; see Palettes.CreateAll.
        public static void ColorRun(byte* bytes, in ColorMapping mapping, uint* palettes, int first, int count, double* x,
            double* y, double* z, uint* colors)
        {
            double* values = stackalloc double[ColumnValues.RunLength];
            if (mapping.Mode == ColorMode.Rgb)
            {
                for (int i = 0; i < count; i++)
                    colors[i] = 0xFF000000u;
                AddChannel(bytes, mapping, mapping.First, first, count, values, 0, colors);
                AddChannel(bytes, mapping, mapping.Second, first, count, values, 8, colors);
                AddChannel(bytes, mapping, mapping.Third, first, count, values, 16, colors);
                return;
            }
            if (mapping.Mode == ColorMode.Elevation)
            {
                var weights = mapping.PositionWeights;
                for (int i = 0; i < count; i++)
                    values[i] = x[i] * weights.x + y[i] * weights.y + z[i] * weights.z;
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

        static void AddChannel(byte* bytes, in ColorMapping mapping, PointColumn column, int first, int count, double* values,
            int shift, uint* colors)
        {
            ColumnValues.ToDoubles(bytes + column.OffsetBytes, column.Type, first, count, values);
            for (int i = 0; i < count; i++)
                colors[i] |= (uint)ToIndex(values[i] * mapping.Scale + mapping.Bias) << shift;
        }

        // NaN becomes 0.
        static int ToIndex(double value) => !(value > 0) ? 0 : value < 255 ? (int)value : 255;
    }
}
