using System.Collections;

namespace FastPoints.Cli.Page;

sealed class ViewPoints(int count)
{
    public int Count { get; } = count;
    public ViewValues[] Positions { get; } = new ViewValues[3];
    public Dictionary<string, ViewValues> Attributes { get; } = [];

    public static ViewPoints Of(PointBatch batch, int count, PositionTransform transform)
    {
        var points = new ViewPoints(count);
        for (int i = 0; i < batch.Schema.Count; i++)
        {
            var attribute = batch.Schema[i];
            byte[] stored = batch.Bytes.GetSubArray((int)batch.Column(i).OffsetBytes, count * attribute.Type.SizeOf()).ToArray();
            if (attribute.Name is AttributeNames.X or AttributeNames.Y or AttributeNames.Z)
            {
                int axis = attribute.Name[0] - 'X';
                points.Positions[axis] = new(stored, attribute.Type, transform.Scale[axis], transform.Offset[axis]);
            }
            else
            {
                points.Attributes[attribute.Name] = new(stored, attribute.Type, attribute.Scale, attribute.Offset);
            }
        }
        return points;
    }

    /// <summary>One behind the other; what some lack is 0 for those.</summary>
    public static ViewPoints Join(IReadOnlyList<ViewPoints> parts)
    {
        if (parts.Count == 1)
            return parts[0];
        var joined = new ViewPoints(parts.Sum(p => p.Count));
        foreach (string name in parts.SelectMany(p => p.Attributes.Keys).Distinct())
            joined.Attributes[name] = ViewValues.Of(parts.SelectMany(p =>
                p.Attributes.GetValueOrDefault(name) ?? Enumerable.Repeat(0.0, p.Count)));
        for (int axis = 0; axis < 3; axis++)
            joined.Positions[axis] = ViewValues.Of(parts.SelectMany(p => p.Positions[axis]));
        return joined;
    }

    public double3 this[int point] => new(Positions[0][point], Positions[1][point], Positions[2][point]);

    public double Spacing(BoundsGeo bounds, double3 lengths)
    {
        const int PointsOfCube = 6;
        var size = bounds.Size * lengths;
        double edge = math.max(math.cmax(size), 1e-9) / 16;
        for (int halving = 0; ; halving++, edge /= 2)
        {
            var cubes = new Dictionary<Cube, int>();
            int inside = 0;
            for (int i = 0; i < Count; i++)
            {
                var place = (this[i] - bounds.Min) * lengths / edge;
                if (math.any(place < 0) || math.any(place > 1 << 20))
                    continue;
                var cube = new Cube((int)place.x, (int)place.y, (int)place.z);
                cubes[cube] = cubes.GetValueOrDefault(cube) + 1;
                inside++;
            }
            if (inside <= PointsOfCube * cubes.Count || halving == 14)
                return edge / Math.Sqrt(cubes.Count == 0 ? 1 : cubes.Values.Order().ElementAt(cubes.Count / 2));
        }
    }

    readonly record struct Cube(int X, int Y, int Z);
}

/// <summary>A column as the file has it: as doubles, it would take up to eight times the memory.</summary>
sealed class ViewValues(byte[] stored, AttributeType type, double scale, double offset) : IReadOnlyList<double>
{
    public int Count { get; } = stored.Length / type.SizeOf();
    public AttributeType Type => type;
    public double Scale => scale;

    /// <summary>Integers of 64 bits go to a browser as doubles, as it has no others.</summary>
    AttributeType TypeSent => type is AttributeType.Int64 or AttributeType.UInt64 ? AttributeType.Float64 : type;

    /// <summary>What the browser makes of the values that <see cref="Pack"/> writes.</summary>
    /// <param name="shownScale">In place of the file's.</param>
    public void WriteType(Utf8JsonWriter json, double shownScale)
    {
        json.WriteString("type", TypeSent.ToString());
        json.WriteNumber("scale", shownScale);
        json.WriteNumber("offset", offset);
        if (!type.IsFloat())
            json.WriteNumber("decimals", Math.Max(DecimalsOf(shownScale), DecimalsOf(offset)));
    }

    /// <summary>Digits after the point that are worth showing: all of integers, of floats as many as a metre's tenths of
    /// millimetres.</summary>
    public int Decimals => type.IsFloat() ? 4 : Math.Max(DecimalsOf(scale), DecimalsOf(offset));

    /// <summary>Digits after the point that write a number in full, at most 12.</summary>
    static int DecimalsOf(double value)
    {
        int decimals = 0;
        while (decimals < 12 && Math.Round(value, decimals) != value)
            decimals++;
        return decimals;
    }

    /// <summary>Writes some of the values, exact: zigzag-coded differences from one to the next, low bytes of all first, which
    /// deflate packs best. Doubles are two numbers each, low bits first.</summary>
    public IEnumerable<Differences> Pack(int[] kept, Stream packed)
    {
        int width = TypeSent.SizeOf(), bits = Math.Min(32, 8 * width);
        var differences = new uint[kept.Length];
        var plane = new byte[kept.Length];
        for (int number = 0; number < (width + 3) / 4; number++)
        {
            int step = width is 2 or 4 && !TypeSent.IsFloat() ? StepOf(kept) : 1;
            int first = step > 1 ? (int)ToInteger(kept[0]) : 0;
            long before = first;
            uint all = 0;
            for (int i = 0; i < kept.Length; i++)
            {
                long value = step > 1 ? ToInteger(kept[i]) : (uint)(BitsOf(kept[i]) >> 32 * number);
                int difference = step > 1 ? (int)((value - before) / step) : (int)(value - before << 32 - bits) >> 32 - bits;
                differences[i] = (uint)(difference << 1 ^ difference >> 31);
                all |= differences[i];
                before = value;
            }
            int bytes = 0;
            for (; all != 0; all >>= 8, bytes++)
            {
                for (int i = 0; i < plane.Length; i++)
                    plane[i] = (byte)(differences[i] >> 8 * bytes);
                packed.Write(plane);
            }
            yield return new Differences(bytes, first, step);
        }
    }

    long ToInteger(int point) => (long)Math.Round((this[point] - offset) / scale);

    /// <summary>The greatest common divisor of all differences of integers: 257 of colours that had 8 bits once.</summary>
    int StepOf(int[] kept)
    {
        long step = 0;
        for (int i = 1; i < kept.Length && step != 1; i++)
            for (long rest = Math.Abs(ToInteger(kept[i]) - ToInteger(kept[i - 1])); rest != 0;)
                (step, rest) = (rest, step % rest);
        return step is > 1 and <= int.MaxValue ? (int)step : 1;
    }

    ulong BitsOf(int point)
    {
        var bytes = stored.AsSpan(point * type.SizeOf());
        return type switch
        {
            AttributeType.Int64 => BitConverter.DoubleToUInt64Bits(MemoryMarshal.Read<long>(bytes)),
            AttributeType.UInt64 => BitConverter.DoubleToUInt64Bits(MemoryMarshal.Read<ulong>(bytes)),
            _ => BitsOf(bytes),
        };
    }

    ulong BitsOf(ReadOnlySpan<byte> bytes) =>
        type.SizeOf() switch
        {
            1 => bytes[0],
            2 => MemoryMarshal.Read<ushort>(bytes),
            4 => MemoryMarshal.Read<uint>(bytes),
            _ => MemoryMarshal.Read<ulong>(bytes),
        };

    public unsafe double this[int point]
    {
        get
        {
            double value;
            fixed (byte* first = stored)
                ColumnValues.ToDoubles(first, type, point, 1, &value);
            return value * scale + offset;
        }
    }

    public static ViewValues Of(IEnumerable<double> values) =>
        new(MemoryMarshal.AsBytes(values.ToArray().AsSpan()).ToArray(), AttributeType.Float64, 1, 0);

    public IEnumerator<double> GetEnumerator()
    {
        for (int i = 0; i < Count; i++)
            yield return this[i];
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}

/// <summary>How a column's differences are written.</summary>
/// <param name="Bytes">Of each.</param>
/// <param name="First">What the first value differs from.</param>
readonly record struct Differences(int Bytes, int First, int Step);

/// <param name="Rms">Distance from points of the cloud to the nearest of these; NaN where it was not measured.</param>
/// <param name="Flip">See <see cref="WaveFlips"/>.</param>
sealed record ViewWave(int Set, int Points, double Seconds, long BytesRead, double Rms, double Flip);
