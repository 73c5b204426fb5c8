using System.Collections;
using System.Runtime.InteropServices;

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

/// <param name="Rms">Distance from points of the cloud to the nearest of these; NaN where it was not measured.</param>
sealed record ViewWave(int Set, int Points, double Seconds, long BytesRead, double Rms);
