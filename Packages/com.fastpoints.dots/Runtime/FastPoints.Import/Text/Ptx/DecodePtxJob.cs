using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Text
{
    // Leaves out grid cells without a return (0 0 0) and invalid lines.
    [BurstCompile]
    unsafe struct DecodePtxJob : IJob
    {
        // Not read-only: a line end is put behind the last byte, so that no loop has to check for the buffer's end.
        public NativeArray<byte> Input;
        public AsciiRange Range;
        public PtxScanHeader Scan;
        public ushort ScanNumber;
        public PtxColumnOffsets Columns;
        [WriteOnly] public NativeArray<byte> Output;
        [WriteOnly] public NativeReference<DecodeResult> Result;
        [WriteOnly] public NativeReference<PtxAnomalies> Anomalies;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafePtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            byte* end = input + Range.Bytes, blockEnd = input + Range.BlockBytes;
            *end = (byte)'\n';
            byte* p = Range.StartsInRow ? AsciiLines.LineEnd(input) : input;
            int points = 0;
            var anomalies = default(PtxAnomalies);
            for (int row = -Range.RowsBefore; row < Range.Rows; row++)
            {
                while (p < end && *p <= ' ')
                    p++;
                if (p >= blockEnd)
                    break;
                byte* start = p;
                if (row >= 0)
                {
                    bool isWhole = TryPosition(ref p, out var position);
                    if (isWhole && !position.Equals(default))
                        isWhole = TryStore(ref p, output, position, ref points);
                    if (!isWhole && anomalies.BadRows++ == 0)
                        anomalies.FirstBadRow = Range.Offset + (start - input);
                }
                p = AsciiLines.LineEnd(p);
            }
            Result.Value = new DecodeResult { Points = points };
            Anomalies.Value = anomalies;
        }

        static bool TryPosition(ref byte* p, out double3 position)
        {
            position = default;
            for (int axis = 0; axis < 3; axis++)
            {
                AsciiLines.SkipBlanks(ref p);
                if (AsciiLines.IsLineEnd(*p) || !AsciiNumber.TryDouble(ref p, out double value))
                    return false;
                position[axis] = value;
            }
            return true;
        }

        bool TryStore(ref byte* p, byte* output, double3 position, ref int points)
        {
            int row = points;
            float intensity = 0;
            var color = default(int3);
            if (Columns.ValuesPerLine >= 4)
            {
                AsciiLines.SkipBlanks(ref p);
                if (AsciiLines.IsLineEnd(*p) || !AsciiNumber.TryFloat(ref p, out intensity))
                    return false;
            }
            for (int i = 0; i < Columns.ValuesPerLine - 4; i++)
            {
                AsciiLines.SkipBlanks(ref p);
                if (AsciiLines.IsLineEnd(*p) || !AsciiNumber.TryInteger(ref p, out ulong value, out bool isNegative, out _))
                    return false;
                color[i] = isNegative ? 0 : (int)math.min(value, 255);
            }
            var world = position.x * Scan.X + position.y * Scan.Y + position.z * Scan.Z + Scan.Shift;
            for (int axis = 0; axis < 3; axis++)
            {
                if (Columns.Position[axis] >= 0)
                    ((double*)(output + Columns.Position[axis]))[row] = world[axis];
                if (Columns.Color[axis] >= 0)
                    output[Columns.Color[axis] + row] = (byte)color[axis];
            }
            if (Columns.Intensity >= 0)
                ((float*)(output + Columns.Intensity))[row] = intensity;
            if (Columns.ScanNumber >= 0)
                ((ushort*)(output + Columns.ScanNumber))[row] = ScanNumber;
            points++;
            return true;
        }
    }

    // Offsets of the batch's columns; -1 for those that are not wanted. Blittable.
    struct PtxColumnOffsets
    {
        // In a line: position; intensity; colour.
        public int ValuesPerLine;
        public int3 Position;
        public int3 Color;
        public int Intensity;
        public int ScanNumber;
    }

    struct PtxAnomalies
    {
        public int BadRows;
        public long FirstBadRow;
    }
}
