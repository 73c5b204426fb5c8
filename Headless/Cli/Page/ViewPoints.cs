namespace FastPoints.Cli.Page;

/// <summary>Points for a page, by column: georeferenced positions and attributes as they are meant, scaled.</summary>
sealed class ViewPoints(int count)
{
    public int Count { get; } = count;

    /// <summary>X, Y, Z.</summary>
    public double[][] Positions { get; } = [new double[count], new double[count], new double[count]];

    public Dictionary<string, double[]> Attributes { get; } = [];

    /// <param name="count">The first so many of the batch.</param>
    public static unsafe ViewPoints Of(PointBatch batch, int count, PositionTransform transform)
    {
        var points = new ViewPoints(count);
        var bytes = (byte*)Unity.Collections.LowLevel.Unsafe.NativeArrayUnsafeUtility.GetUnsafeReadOnlyPtr(batch.Bytes);
        for (int i = 0; i < batch.Schema.Count; i++)
        {
            var attribute = batch.Schema[i];
            int axis = attribute.Name is AttributeNames.X or AttributeNames.Y or AttributeNames.Z ? attribute.Name[0] - 'X' : -1;
            double[] values = axis >= 0 ? points.Positions[axis] : points.Attributes[attribute.Name] = new double[count];
            fixed (double* first = values)
                ColumnValues.ToDoubles(bytes + batch.Column(i).OffsetBytes, attribute.Type, 0, count, first);
            double scale = axis >= 0 ? transform.Scale[axis] : attribute.Scale;
            double offset = axis >= 0 ? transform.Offset[axis] : attribute.Offset;
            for (int p = 0; p < count && (scale != 1 || offset != 0); p++)
                values[p] = values[p] * scale + offset;
        }
        return points;
    }

    /// <summary>One behind the other; what some lack is 0 for those.</summary>
    public static ViewPoints Join(IReadOnlyList<ViewPoints> parts)
    {
        var joined = new ViewPoints(parts.Sum(p => p.Count));
        foreach (string name in parts.SelectMany(p => p.Attributes.Keys).Distinct())
            joined.Attributes[name] = parts.SelectMany(p =>
                p.Attributes.GetValueOrDefault(name) ?? new double[p.Count]).ToArray();
        for (int axis = 0; axis < 3; axis++)
            joined.Positions[axis] = parts.SelectMany(p => p.Positions[axis]).ToArray();
        return joined;
    }

    public double3 this[int point] => new(Positions[0][point], Positions[1][point], Positions[2][point]);

    /// <summary>About how far points are from their neighbours, as on surfaces, where half of the space has them nearer: by the
    /// cubes that they occupy, of an edge that leaves some points to each.</summary>
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

/// <summary>A beginning of a sample, as a page shows it.</summary>
/// <param name="Set">Which points it is the beginning of.</param>
/// <param name="Rms">Distance from points of the cloud to the nearest of these; NaN where it was not measured.</param>
sealed record ViewWave(int Set, int Points, double Seconds, long BytesRead, double Rms);
