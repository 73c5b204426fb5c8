using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Text
{
    // A line that is not a point is counted and left out.
    [BurstCompile]
    unsafe struct DecodeXyzJob : IJob
    {
        static readonly ulong[] s_powersOfTen =
        {
            1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000, 10000000000, 100000000000, 1000000000000,
            10000000000000, 100000000000000, 1000000000000000, 10000000000000000, 100000000000000000, 1000000000000000000,
            10000000000000000000,
        };

        // Not read-only: separators are rewritten in place, and a line end is put behind the last byte, so that no loop has to
        // check for the buffer's end.
        public NativeArray<byte> Input;

        public AsciiRange Range;
        public XyzDialect Dialect;
        [ReadOnly] public NativeArray<XyzStep> Steps;
        [WriteOnly] public NativeArray<byte> Output;
        [WriteOnly] public NativeReference<DecodeResult> Result;
        [WriteOnly] public NativeReference<XyzAnomalies> Anomalies;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafePtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            byte* end = input + Range.Bytes;
            byte* blockEnd = input + Range.BlockBytes;
            Dialect.Apply(input, Range.Bytes);
            *end = (byte)'\n';
            byte* p = Range.StartsInRow ? AsciiLines.LineEnd(input) : input;
            byte mark = Dialect.Separator != 0 ? XyzDialect.Mark : (byte)'\n';
            int points = 0;
            var anomalies = default(XyzAnomalies);
            for (int row = -Range.RowsBefore; row < Range.Rows; row++)
            {
                while (p < end && *p <= ' ' && (*p != mark || AsciiLines.IsLineEnd(*p)))
                    p++;
                if (p >= blockEnd)
                    break;
                byte* start = p;
                if (row < 0)
                {
                    p = AsciiLines.LineEnd(p);
                    continue;
                }
                if (Dialect.IsComment(*p))
                {
                    anomalies.Comments++;
                    p = AsciiLines.LineEnd(p);
                    continue;
                }
                var error = Row(ref p, input, output, points, mark, ref anomalies);
                p = AsciiLines.LineEnd(p);
                if (p == end && !Range.ReachesFileEnd)
                    error = XyzError.LineTooLong;
                if (error == XyzError.None)
                {
                    points++;
                }
                else if (anomalies.BadRows++ == 0)
                {
                    anomalies.FirstBadRow = Range.Offset + (start - input);
                    anomalies.FirstError = error;
                }
            }
            Result.Value = new DecodeResult { Points = points };
            Anomalies.Value = anomalies;
        }

        XyzError Row(ref byte* p, byte* input, byte* output, int row, byte mark, ref XyzAnomalies anomalies)
        {
            int steps = Steps.Length;
            var step = (XyzStep*)Steps.GetUnsafeReadOnlyPtr();
            for (int i = 0; i < steps; i++, step++)
            {
                SkipBlanks(ref p, mark);
                if (i > 0 && *p == mark && !AsciiLines.IsLineEnd(mark))
                {
                    p++;
                    SkipBlanks(ref p, mark);
                }
                byte* text = p;
                byte* column = output + step->ColumnOffsetBytes;
                if (*p == mark || AsciiLines.IsLineEnd(*p))
                {
                    // Nothing between two separators, or behind the last one, means an unknown value.
                    bool isEmpty = !AsciiLines.IsLineEnd(mark) && (*p == mark || i > 0 && p[-1] <= ' ' && EndsInMark(text, mark));
                    if (!isEmpty || step->IsPosition)
                        return XyzError.TooFewValues;
                    if (step->Kind != XyzStepKind.Skip && step->Kind != XyzStepKind.Check)
                    {
                        AsciiLines.StoreClamped(column, row, step->Type, step->Bytes, 0, false);
                        if (anomalies.EmptyValues++ == 0)
                            anomalies.FirstEmpty = Range.Offset + (text - input);
                    }
                    continue;
                }
                switch (step->Kind)
                {
                    case XyzStepKind.Skip:
                        while (*p > ' ')
                            p++;
                        break;
                    case XyzStepKind.Check:
                        if (!AsciiNumber.TrySkip(ref p))
                            return XyzError.NoNumber;
                        break;
                    case XyzStepKind.Coordinate:
                        if (!AsciiNumber.TryDecimal(ref p, out var number))
                            return XyzError.NoNumber;
                        if (!ToGridPosition(number, step->Decimals, out long position, out bool isWhole))
                            return XyzError.TooLarge;
                        if (!isWhole && anomalies.Rounded++ == 0)
                            anomalies.FirstRounded = Range.Offset + (text - input);
                        if (step->IsStored)
                            ((long*)column)[row] = position;
                        break;
                    case XyzStepKind.Integer:
                        if (!AsciiNumber.TryInteger(ref p, out ulong magnitude, out bool isNegative, out bool isExact))
                            return XyzError.NoNumber;
                        bool fits = AsciiLines.StoreClamped(column, row, step->Type, step->Bytes, magnitude, isNegative);
                        if (!(fits && isExact) && anomalies.Inexact++ == 0)
                            anomalies.FirstInexact = Range.Offset + (text - input);
                        break;
                    case XyzStepKind.Float32:
                        if (!AsciiNumber.TryFloat(ref p, out ((float*)column)[row]))
                            return XyzError.NoNumber;
                        break;
                    default:
                        if (!AsciiNumber.TryDouble(ref p, out ((double*)column)[row]))
                            return XyzError.NoNumber;
                        break;
                }
            }
            SkipBlanks(ref p, mark);
            if (!AsciiLines.IsLineEnd(*p) && anomalies.RowsWithMore++ == 0)
                anomalies.FirstWithMore = Range.Offset + (p - input);
            return XyzError.None;
        }

        // The last character before a line's end, except blanks, is a separator.
        static bool EndsInMark(byte* p, byte mark)
        {
            p--;
            while (*p == ' ' || *p == '\t')
                p--;
            return *p == mark;
        }

        // The nearest multiple of 10^-decimals (halves away from zero); false if it is beyond the grid.
        static bool ToGridPosition(in DecimalDigits number, int decimals, out long position, out bool isExact)
        {
            ulong value = number.Mantissa;
            int exponent = number.Exponent + decimals;
            isExact = !number.IsTruncated;
            position = 0;
            if (exponent < -19)
            {
                isExact &= value == 0;
                value = 0;
            }
            else if (exponent < 0)
            {
                ulong power = s_powersOfTen[-exponent];
                ulong rest = value % power;
                value /= power;
                isExact &= rest == 0;
                if (rest >= power - rest)
                    value++;
            }
            for (; exponent > 0 && value != 0; exponent--)
            {
                if (value > (ulong)CommonGrid.Limit / 10)
                    return false;
                value *= 10;
            }
            if (value >= (ulong)CommonGrid.Limit)
                return false;
            position = number.IsNegative ? -(long)value : (long)value;
            return true;
        }

        static void SkipBlanks(ref byte* p, byte mark)
        {
            while (*p <= ' ' && *p != mark && !AsciiLines.IsLineEnd(*p))
                p++;
        }
    }

    enum XyzStepKind : byte
    {
        Skip,
        Check, // A number that is not requested.
        // A coordinate, as a whole number of 10^-Decimals.
        Coordinate,
        Integer,
        Float32,
        Float64,
    }

    // What to do with one column of a line. Blittable: jobs carry arrays of these.
    struct XyzStep
    {
        public XyzStepKind Kind;
        public AttributeType Type;
        public int Bytes;
        public int Decimals;
        public bool IsPosition; // A line without the value, or with text instead, is not a point.
        public bool IsStored; // Coordinates are always read, so that the same lines are points for any request.

        public int ColumnOffsetBytes;
    }

    struct XyzAnomalies
    {
        public int BadRows;
        public long FirstBadRow;
        public XyzError FirstError;

        public int Comments;

        // Coordinates with more digits than the sample had, rounded to its step.
        public int Rounded;
        public long FirstRounded;
        public int Inexact;
        public long FirstInexact;

        // Between two separators; read as 0.
        public int EmptyValues;
        public long FirstEmpty;

        public int RowsWithMore;
        public long FirstWithMore;
    }

    enum XyzError : byte
    {
        None,
        TooFewValues,
        NoNumber,
        TooLarge,
        LineTooLong,
    }

    struct XyzDialect
    {
        public const byte Mark = 1; // Replaces the separator while a line is read: a number ends at it as at a blank.
        public byte Separator; // A comma or a semicolon; 0 if values are separated by blanks (spaces, tabs).
        public bool HasDecimalComma; // 1,5 means one and a half.

        public bool HasQuotes;

        public string Name => (Separator == ',' ? "comma" : Separator == ';' ? "semicolon" : "blanks") +
            (HasDecimalComma ? ", decimal comma" : "") + (HasQuotes ? ", in quotes" : "");

        // Rewrites text so that AsciiNumber can read it.
        public unsafe void Apply(byte* text, int count)
        {
            if (Separator == 0 && !HasDecimalComma && !HasQuotes)
                return;
            byte separator = Separator != 0 ? Separator : Mark;
            byte comma = HasDecimalComma ? (byte)',' : Mark;
            byte quote = HasQuotes ? (byte)'"' : Mark;
            for (int i = 0; i < count; i++)
            {
                byte b = text[i];
                b = b == separator ? Mark : b;
                b = b == comma && comma != Mark ? (byte)'.' : b;
                text[i] = b == quote && quote != Mark ? (byte)' ' : b;
            }
        }

        public bool IsComment(byte first) =>
            first == '#' || first == '/' || first == '%' || first == '!' || first == ';' && Separator != ';';
    }
}
