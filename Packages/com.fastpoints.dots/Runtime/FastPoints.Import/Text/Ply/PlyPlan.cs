using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Text
{
    // A line that lacks a value or has an invalid one ends the block there; unwanted values are skipped unread.
    [BurstCompile]
    unsafe struct DecodePlyAsciiJob : IJob
    {
        // Not read-only: a line end is written after the last byte, so that no loop has to check for the buffer's end.
        public NativeArray<byte> Input;
        public AsciiRange Range;
        [ReadOnly] public NativeArray<PlyStep> Steps;
        [WriteOnly] public NativeArray<byte> Output;
        [WriteOnly] public NativeReference<DecodeResult> Result;
        [WriteOnly] public NativeReference<PlyAnomalies> Anomalies;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafePtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            byte* end = input + Range.Bytes;
            byte* blockEnd = input + Range.BlockBytes;
            *end = (byte)'\n';
            byte* p = Range.StartsInRow ? AsciiLines.LineEnd(input) : input;
            var result = default(DecodeResult);
            var anomalies = default(PlyAnomalies);
            for (int row = -Range.RowsBefore; row < Range.Rows; row++)
            {
                while (p < end && *p <= ' ')
                    p++;
                byte* start = p;
                int error = PlyError.None;
                if (p >= blockEnd)
                    error = PlyError.Truncated;
                else if (row >= 0)
                    error = Row(ref p, input, output, row, ref anomalies);
                byte* at = p;
                if (error != PlyError.Truncated)
                    p = AsciiLines.LineEnd(p);
                if (p == end && row >= 0 && !Range.ReachesFileEnd)
                {
                    error = PlyError.LineTooLong;
                    at = start;
                }
                if (error != PlyError.None)
                {
                    result.Error = error;
                    result.ErrorOffset = Range.Offset + (at - input);
                    break;
                }
                if (row >= 0)
                    result.Points = row + 1;
            }
            Result.Value = result;
            Anomalies.Value = anomalies;
        }

        int Row(ref byte* p, byte* input, byte* output, int row, ref PlyAnomalies anomalies)
        {
            int steps = Steps.Length;
            var step = (PlyStep*)Steps.GetUnsafeReadOnlyPtr();
            for (int i = 0; i < steps; i++, step++)
            {
                AsciiLines.SkipBlanks(ref p);
                if (AsciiLines.IsLineEnd(*p))
                    return PlyError.MissingValue;
                if (step->Kind == PlyStepKind.Value)
                {
                    byte* column = output + step->ColumnOffsetBytes;
                    if (step->Type == AttributeType.Float32)
                    {
                        if (!AsciiNumber.TryFloat(ref p, out float value))
                            return PlyError.BadNumber;
                        ((float*)column)[row] = value;
                    }
                    else if (step->Type == AttributeType.Float64)
                    {
                        if (!AsciiNumber.TryDouble(ref p, out double value))
                            return PlyError.BadNumber;
                        ((double*)column)[row] = value;
                    }
                    else
                    {
                        byte* text = p;
                        if (!AsciiNumber.TryInteger(ref p, out ulong magnitude, out bool isNegative, out bool isExact))
                            return PlyError.BadNumber;
                        bool fits = AsciiLines.StoreClamped(column, row, step->Type, step->Bytes, magnitude, isNegative);
                        if (!fits || !isExact)
                        {
                            if (anomalies.Inexact++ == 0)
                                anomalies.FirstInexactOffset = Range.Offset + (text - input);
                        }
                    }
                    continue;
                }
                if (step->Kind == PlyStepKind.PackedColor)
                {
                    if (!Color(ref p, output, row, step))
                        return PlyError.BadNumber;
                    continue;
                }
                ulong values = (ulong)step->Count;
                if (step->Kind == PlyStepKind.List)
                {
                    byte* text = p;
                    if (!AsciiNumber.TryInteger(ref p, out values, out bool isNegative, out bool isExact) || !isExact)
                    {
                        p = text;
                        return PlyError.BadNumber;
                    }
                    if (isNegative && values != 0)
                    {
                        p = text;
                        return PlyError.BadListLength;
                    }
                }
                for (; values > 0; values--)
                {
                    AsciiLines.SkipBlanks(ref p);
                    if (AsciiLines.IsLineEnd(*p))
                        return PlyError.MissingValue;
                    while (*p > ' ')
                        p++;
                }
            }
            AsciiLines.SkipBlanks(ref p);
            if (!AsciiLines.IsLineEnd(*p) && anomalies.LinesWithExtraValues++ == 0)
                anomalies.FirstExtraOffset = Range.Offset + (p - input);
            return PlyError.None;
        }

        // An integer, or a float whose bits are the colour.
        static bool Color(ref byte* p, byte* output, int row, PlyStep* step)
        {
            uint bits;
            if (step->Type == AttributeType.Float32)
            {
                if (!AsciiNumber.TryFloat(ref p, out float value))
                    return false;
                bits = *(uint*)&value;
            }
            else
            {
                if (!AsciiNumber.TryInteger(ref p, out ulong magnitude, out bool isNegative, out _))
                    return false;
                bits = (uint)(isNegative ? 0 - magnitude : magnitude);
            }
            if (step->ColumnOffsetBytes >= 0)
                output[step->ColumnOffsetBytes + row] = (byte)(bits >> 16);
            if (step->GreenOffsetBytes >= 0)
                output[step->GreenOffsetBytes + row] = (byte)(bits >> 8);
            if (step->BlueOffsetBytes >= 0)
                output[step->BlueOffsetBytes + row] = (byte)bits;
            if (step->AlphaOffsetBytes >= 0)
                output[step->AlphaOffsetBytes + row] = (byte)(bits >> 24);
            return true;
        }
    }

    static class PlyError
    {
        public const int None = 0;
        public const int MissingValue = 1;
        public const int BadNumber = 2;
        public const int LineTooLong = 3;
        public const int BadListLength = 4;
        public const int Truncated = 5;
        public const int RecordTooLong = 6;

        public static string Text(int error) => error switch
        {
            MissingValue => "the line ends before the vertex has all its values",
            BadNumber => "not a number",
            LineTooLong => "the line is longer than 65,536 bytes",
            BadListLength => "a list of negative length",
            Truncated => "the file ends within an element",
            RecordTooLong => "a vertex of more than 16 MiB",
            _ => "error " + error,
        };
    }

    struct PlyAnomalies
    {
        public int Inexact;
        public long FirstInexactOffset;

        public int LinesWithExtraValues;
        public long FirstExtraOffset;
    }

    static class PlyPlan
    {
        public static List<PlyStep> Skipping(PlyElement element) => Build(element, null, null);

        public static List<PlyStep> Decoding(PlyElement element, string[] names, PointBatch batch) =>
            Build(element, names, batch);

        public static readonly string[] ColorNames =
        {
            AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue, AttributeNames.Alpha,
        };

        static PlyStep ColorStep(PlyProperty property, PointBatch batch)
        {
            int Offset(int i)
            {
                int column = i == 3 && !property.HasAlpha ? -1 : batch.Schema.IndexOf(ColorNames[i]);
                return column < 0 ? -1 : batch.Column(column).OffsetBytes;
            }
            return new PlyStep
            {
                Kind = PlyStepKind.PackedColor,
                Type = property.Type,
                Bytes = property.Type.SizeOf(),
                Count = 1,
                ColumnOffsetBytes = Offset(0),
                GreenOffsetBytes = Offset(1),
                BlueOffsetBytes = Offset(2),
                AlphaOffsetBytes = Offset(3),
            };
        }

        static List<PlyStep> Build(PlyElement element, string[] names, PointBatch batch)
        {
            var steps = new List<PlyStep>();
            for (int i = 0; i < element.Properties.Count; i++)
            {
                var property = element.Properties[i];
                if (property.IsPackedColor && batch != null)
                {
                    steps.Add(ColorStep(property, batch));
                    continue;
                }
                int column = batch == null || property.IsList || names[i] == null ? -1 : batch.Schema.IndexOf(names[i]);
                if (property.IsList)
                {
                    steps.Add(new PlyStep
                    {
                        Kind = PlyStepKind.List,
                        Type = property.CountType,
                        Bytes = property.CountType.SizeOf(),
                        ItemBytes = property.Type.SizeOf(),
                    });
                }
                else if (column >= 0)
                {
                    steps.Add(new PlyStep
                    {
                        Kind = PlyStepKind.Value,
                        Type = property.Type,
                        Bytes = property.Type.SizeOf(),
                        Count = 1,
                        ColumnOffsetBytes = batch.Column(column).OffsetBytes,
                    });
                }
                else
                {
                    var skip = new PlyStep { Kind = PlyStepKind.Skip };
                    int last = steps.Count - 1;
                    if (last >= 0 && steps[last].Kind == PlyStepKind.Skip)
                    {
                        skip = steps[last];
                        steps.RemoveAt(last);
                    }
                    skip.Count++;
                    skip.Bytes += property.Type.SizeOf();
                    steps.Add(skip);
                }
            }
            return steps;
        }
    }

    enum PlyStepKind : byte
    {
        Skip,
        Value,
        List,
        PackedColor, // In text: a number whose bits are a colour.
    }

    // One step through one instance of an element. Blittable: jobs carry arrays of these.
    struct PlyStep
    {
        public PlyStepKind Kind;
        public AttributeType Type;
        public int Count; // Skip: number of values.
        public int ItemBytes; // List.
        public int Bytes; // In a binary file: bytes of the skipped values, of the value, or of a list's count.

        // Value: offset of its column in the batch. Colour: of red, or -1.
        public int ColumnOffsetBytes;
        public int GreenOffsetBytes;
        public int BlueOffsetBytes;
        public int AlphaOffsetBytes;
    }
}
