using System;
using System.Globalization;
using System.Text;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Text
{
    // The ten lines before the points of each scan: columns, rows, the scanner's place and axes, and the matrix that takes its
    // points to the world, row by row, the shift last.
    struct PtxScanHeader
    {
        public const int MaxBytes = 4096;

        static readonly int[] s_valuesOfLine = { 1, 1, 3, 3, 3, 3, 4, 4, 4, 4 };

        public ulong Columns;
        public ulong Rows;

        // World = x * X + y * Y + z * Z + Shift.
        public double3 X, Y, Z, Shift;

        public int Bytes;

        // Lines of points, those without a return included.
        public ulong Places => Rows != 0 && Columns > ulong.MaxValue / Rows ? ulong.MaxValue : Columns * Rows;

        public static bool TryParse(ReadOnlySpan<byte> bytes, out PtxScanHeader header)
        {
            header = default;
            var rows = new double4[4];
            for (int line = 0; line < s_valuesOfLine.Length;)
            {
                int end = bytes.Slice(header.Bytes).IndexOfAny((byte)'\n', (byte)'\r');
                if (end < 0)
                    return false;
                string[] words = Encoding.ASCII.GetString(bytes.Slice(header.Bytes, end).ToArray())
                    .Split((char[])null, StringSplitOptions.RemoveEmptyEntries);
                header.Bytes += end + 1;
                if (words.Length == 0)
                    continue;
                if (words.Length != s_valuesOfLine[line] || !Take(ref header, rows, line, words))
                    return false;
                line++;
            }
            (header.X, header.Y, header.Z, header.Shift) = (rows[0].xyz, rows[1].xyz, rows[2].xyz, rows[3].xyz);
            return true;
        }

        static bool Take(ref PtxScanHeader header, double4[] rows, int line, string[] words)
        {
            if (line < 2)
                return ulong.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture,
                    out line == 0 ? ref header.Columns : ref header.Rows);
            for (int i = 0; i < words.Length; i++)
            {
                if (!NumberText.TryRead(words[i], out double value) || double.IsNaN(value) || double.IsInfinity(value))
                    return false;
                if (line >= 6)
                    rows[line - 6][i] = value;
            }
            return true;
        }
    }
}
