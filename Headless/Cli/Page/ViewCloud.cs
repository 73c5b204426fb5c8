using System.IO.Compression;

namespace FastPoints.Cli.Page;

/// <summary>What a page's 3D view shows: points in waves as a preview takes them, with the values
/// of the file, and a camera or a path of one.</summary>
sealed class ViewCloud
{
    public const int MaxPoints = 400_000;
    const double TriedShare = 1 / 8.0; // Of the points, packed to see how many fit.

    const double Base64Growth = 4 / 3.0;

    const double FarBounds = 4;
    const int ColorsOfPoints = -2; // A mode of the view's script; -1 is the elevation, and from 0 on they are columns.

    readonly List<ViewPoints> m_sets = [];
    readonly PictureOptions m_options;
    List<ViewColumn> m_columns = [];

    ViewCloud(PictureOptions options, DisplayRanges ranges) => (m_options, Ranges) = (options, ranges);

    public DisplayRanges Ranges { get; }
    public string Unit => NumberFormat.Unit(Ranges.Units.Horizontal);
    public List<ViewWave> Waves { get; } = [];

    public double FlipFloor { get; private set; } // FLIP of all points with one sample a pixel; see WaveFlips.

    /// <summary>What is shown: everything, or what nearly all points are in where few far ones would leave it too few
    /// pixels.</summary>
    public BoundsGeo Bounds { get; private set; } = new(new double3(0, 0, 0), new double3(1, 1, 1));

    public ViewPoints Points => m_sets[^1];
    public double Spacing { get; private set; }
    public required Camera Camera { get; init; }
    public required CloudCrs Crs { get; init; }

    /// <summary>What a command line that exports a part of it reads.</summary>
    public string Source { get; init; } = "";
    public (List<Camera> Cameras, int Every)? Path { get; init; }

    public static ViewCloud OfSource(Func<PointReader> open, string source, string cloud, PictureOptions options, CliRun run)
    {
        var preview = new PreviewOptions { Points = MaxPoints, Picture = options };
        using var reader = open();
        using var taken = new SampleMethods(() => SamplingAllAttributes(open()), preview, run) { Runs = 1 }.Ours();
        var errors = WaveErrors.Measure(reader, taken, run);
        var flips = WaveFlips.Measure(cloud, taken, options, run);
        var view = new ViewCloud(options, new DisplayRanges { Units = reader.Info.Crs.Units })
        {
            Camera = options.Camera!.Value,
            FlipFloor = flips.Floor,
            Crs = reader.Info.Crs.ToCloudCrs(),
            Source = source,
        };
        for (int i = 0; i < taken.Waves.Count; i++)
        {
            var (wave, points) = taken.Waves[i];
            bool isLastOfBatch = i + 1 == taken.Waves.Count || taken.Waves[i + 1].Points != points;
            view.Waves.Add(new ViewWave(view.m_sets.Count, wave.Points, wave.Seconds, wave.BytesRead, errors[i],
                flips.OfWave[i]));
            if (isLastOfBatch)
                view.m_sets.Add(ViewPoints.Of(points, wave.Points, taken.Transform));
        }
        if (taken.Waves.Count > 0)
            run.RunSteps(view.Ranges.Measure(taken.Waves[^1].Points, taken.Transform, options.UpAxis));
        view.Prepare();
        return view;
    }

    /// <param name="every">The frames from one camera to the next; 0 for a single camera.</param>
    public static ViewCloud OfFlight(string[] clouds, PictureOptions options, List<Camera> cameras, int every, CliRun run)
    {
        ViewCloud? view = null;
        var parts = new List<ViewPoints>();
        foreach (string cloud in clouds)
        {
            using var batch = Load(cloud, MaxPoints / clouds.Length, run, out var transform, out var crs);
            var ranges = new DisplayRanges { Units = crs.Units };
            run.RunSteps(ranges.Measure(batch, transform, options.UpAxis));
            parts.Add(ViewPoints.Of(batch, batch.Count, transform));
            view ??= new ViewCloud(options, ranges)
            {
                Camera = cameras[0],
                Path = every > 0 ? (cameras, every) : null,
                Crs = crs,
                Source = clouds.Length == 1 ? CloudReportPage.QuotedWithoutQuery(cloud) : "",
            };
            if (ranges.Full.IsEmpty)
                continue;
            view.Ranges.Full = Union(view.Ranges.Full, ranges.Full);
            view.Ranges.Robust = Union(view.Ranges.Robust, ranges.Robust);
            view.Ranges.ElevationLow = Math.Min(view.Ranges.ElevationLow, ranges.ElevationLow);
            view.Ranges.ElevationHigh = Math.Max(view.Ranges.ElevationHigh, ranges.ElevationHigh);
        }
        view!.m_sets.Add(ViewPoints.Join(parts));
        view.Prepare();
        return view;
    }

    static BoundsGeo Union(BoundsGeo a, BoundsGeo b) => new(math.min(a.Min, b.Min), math.max(a.Max, b.Max));

    static PointBatch Load(string path, int max, CliRun run, out PositionTransform transform, out CloudCrs crs)
    {
        if (!CloudFolder.IsCloud(path))
        {
            using var reader = SamplingAllAttributes(PointReaders.Open(path));
            using var sampler = RunSampler(reader, max, run);
            (transform, crs) = (reader.Info.Transform, reader.Info.Crs.ToCloudCrs());
            return sampler.TakeSample().Points;
        }
        using var folder = CloudFolder.Open(path);
        using var selection = new NodeSelection(folder) { Edits = EditPlan.Of(folder, out _) };
        selection.Choose(null, max);
        var schema = LoadNodes.SchemaFor(folder, folder.Manifest.Attributes.Select(a => a.Name).ToArray());
        var batch = new PointBatch(schema, checked((int)selection.Points), Allocator.Persistent);
        run.RunSteps(selection.Load(batch, null));
        transform = folder.Manifest.Grid.TransformFromCorner(folder.Manifest.Root.Corner);
        crs = folder.Manifest.Crs;
        return batch;
    }

    static PreviewWaveSampler RunSampler(PointReader reader, int max, CliRun run)
    {
        if (!reader.BlocksAreKnown)
            run.RunSteps(reader.IndexBlocks());
        var sampler = new PreviewWaveSampler(reader, max, 1);
        run.RunSteps(sampler.Run(0, null));
        return sampler;
    }

    static PointReader SamplingAllAttributes(PointReader reader)
    {
        reader.Info.ExtraSampledAttributes = reader.Info.Schema.Select(a => a.Name).ToArray();
        return reader;
    }

    void Prepare()
    {
        if (m_sets.Count == 0)
            m_sets.Add(new ViewPoints(0));
        m_columns = ViewColumn.Of(m_sets, Ranges);
        if (!Ranges.Robust.IsEmpty)
            Bounds = math.cmax(Ranges.Full.Size) > FarBounds * math.cmax(Ranges.Robust.Size) ? Ranges.Robust : Ranges.Full;
        Spacing = Points.Spacing(Bounds, Ranges.LengthsPerUnit);
    }

    /// <summary>For the page's script; fewer points where the page would be too large.</summary>
    public string ToJson(int maxBytes, out int shown)
    {
        // A first try with few points costs little, and tells how many fit: one more is enough in most cases.
        double share = Points.Count < MaxPoints / 16 ? 1 : TriedShare;
        while (true)
        {
            var sets = m_sets.Select(s => Pack(s, share)).ToList();
            shown = sets[^1].Kept.Length;
            double bytes = sets.Sum(s => s.Bytes.Length) * Base64Growth;
            if (share == 1 ? bytes <= maxBytes : share != TriedShare && (bytes <= maxBytes || shown < 1000))
                return ToJson(sets);
            share = Math.Min(share == TriedShare ? 1 : 0.97 * share, share * 0.97 * maxBytes / Math.Max(1, bytes));
        }
    }

    string ToJson(List<PackedSet> sets)
    {
        var stream = new MemoryStream((int)(sets.Sum(s => s.Bytes.Length) * Base64Growth) + 100_000);
        using (var json = new Utf8JsonWriter(stream))
        {
            json.WriteStartObject();
            WriteFrame(json, sets[^1].Kept.Length);
            json.WriteStartObject("ramps");
            foreach (var (name, ramp) in new[] { ("viridis", ColorRamp.Viridis), ("gray", ColorRamp.Gray) })
            {
                using var palette = Palettes.Create(ColorMode.Elevation, Allocator.Persistent, ramp);
                json.WriteString(name, string.Concat(palette.Select(ViewColumn.Hex)));
            }
            json.WriteEndObject();
            json.WriteArray("columns", m_columns, column => column.Write(json, Points));
            json.WriteObjects("sets", sets, set =>
            {
                json.WriteNumber("count", set.Kept.Length);
                json.WriteArray("differences", set.Columns, column => json.WriteNumbers(column.Bytes, column.First, column.Step));
                json.WriteBase64String("data", set.Bytes);
            });
            json.WriteObjects("waves", Waves, wave =>
            {
                json.WriteNumber("set", wave.Set);
                json.WriteNumber("shown", sets[wave.Set].Kept.Count(i => i < wave.Points));
                json.WriteString("text", Describe(wave));
            });
            json.WriteEndObject();
        }
        return Encoding.UTF8.GetString(stream.GetBuffer(), 0, (int)stream.Length);
    }

    public string Describe(ViewWave wave) =>
        NumberFormat.Count(wave.Points, "point") + " after " + NumberFormat.Seconds(wave.Seconds)
        + (Ranges.IsInDegrees || double.IsNaN(wave.Rms) ? "" : ": RMS error " + NumberFormat.FourDigits(wave.Rms) + " " + Unit)
        + ", FLIP " + NumberFormat.FourDigits(wave.Flip);

    bool IsInside(double3 geo) => math.all(geo >= Bounds.Min) && math.all(geo <= Bounds.Max);

    void WriteFrame(Utf8JsonWriter json, int shown)
    {
        m_options.UpAxis.Directions(out var east, out var north, out var up);
        var mode = Ranges.Resolve(m_options.Color);
        string name = m_options.ColorAttribute ?? ColorModes.AttributeOf(mode) ?? "";
        json.WriteVector("origin", Bounds.Min);
        json.WriteVector("size", Bounds.Size);
        json.WriteVector("lengths", Ranges.LengthsPerUnit);
        json.WriteNumber("up", m_options.UpAxis.Index());
        json.WriteArray("axes", new[] { east, north, up }, axis => Write(json, axis));
        json.WriteString("unit", Unit);
        json.WriteObjects("position", Points.Positions, axis => axis.WriteType(json, axis.Scale));
        int decimals = Points.Positions.Max(p => p.Decimals);
        json.WriteNumber("clipDecimals", decimals);
        json.WriteNumber("lengthDecimals", Ranges.IsInDegrees ? 3 : Math.Clamp(decimals, 2, 6));
        WriteColor(json);
        json.WriteBoolean("north", SourceFacts.IsNorthAlongY(Crs) && m_options.UpAxis == UpAxis.Z);
        json.WriteString("source", Source);
        // Larger than their distance: slanted surfaces would have holes.
        json.WriteNumber("spacing", 2 * Spacing * Math.Sqrt(Points.Count / Math.Max(1.0, shown)));
        json.WriteNumber("mode", mode == ColorMode.Rgb ? ColorsOfPoints : m_columns.FindIndex(c => c.Name == name));
        json.WriteBoolean("shaded", mode != ColorMode.Rgb);
        json.WriteArray("elevation", new[] { Ranges.ElevationLow, Ranges.ElevationHigh }, json.WriteNumberValue);
        Write(json, "camera", Camera);
        if (Path is not { } path)
            return;
        json.WriteStartObject("path");
        json.WriteNumber("every", path.Every);
        json.WriteArray("cameras", path.Cameras, camera => Write(json, null, camera));
        json.WriteEndObject();
    }

    void Write(Utf8JsonWriter json, string? name, Camera camera)
    {
        if (name != null)
            json.WriteStartObject(name);
        else
            json.WriteStartObject();
        json.WriteVector("eye", (camera.EyeGeo - Bounds.Center) * Ranges.LengthsPerUnit);
        json.WriteVector("forward", camera.Forward / Ranges.LengthsPerUnit);
        json.WriteVector("up", camera.Up / Ranges.LengthsPerUnit);
        json.WriteNumber("fov", camera.IsOrthographic ? 0 : camera.FovRadians);
        json.WriteNumber("height", camera.IsOrthographic ? camera.HeightGeo : 0);
        json.WriteEndObject();
    }

    static void Write(Utf8JsonWriter json, double3 value)
    {
        json.WriteStartArray();
        for (int axis = 0; axis < 3; axis++)
            json.WriteNumberValue(value[axis]);
        json.WriteEndArray();
    }

    /// <summary>How a browser makes 8 bits of a channel.</summary>
    void WriteColor(Utf8JsonWriter json)
    {
        if (Ranges.Color == ColorDepth.None)
            return;
        json.WriteStartObject("rgb");
        json.WriteNumber("scale", Ranges.Color switch { ColorDepth.Unit => 255, ColorDepth.Bits16 => 1 / 256.0, _ => 1 });
        json.WriteNumber("bias", Ranges.Color == ColorDepth.Unit ? 0.5 : 0);
        json.WriteArray("columns", new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue },
            name => json.WriteNumberValue(m_columns.FindIndex(c => c.Name == name)));
        json.WriteEndObject();
    }

    /// <summary>Without what lies far outside, beside which the rest would be a dot.</summary>
    PackedSet Pack(ViewPoints points, double share)
    {
        int[] kept = Enumerable.Range(0, points.Count).Where(i =>
            (i == 0 || (long)(i * share) != (long)((i - 1) * share)) && IsInside(points[i])).ToArray();
        var packed = new MemoryStream();
        var columns = new List<Differences>();
        using (var deflate = new ZLibStream(packed, CompressionLevel.Optimal))
        {
            foreach (var values in points.Positions.Concat(m_columns.Where(c => !c.IsConstant)
                .Select(c => points.Attributes[c.Name])))
                columns.AddRange(values.Pack(kept, deflate));
        }
        return new PackedSet(kept, columns, packed.ToArray());
    }

    sealed record PackedSet(int[] Kept, List<Differences> Columns, byte[] Bytes);
}
