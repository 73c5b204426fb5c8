using System.IO.Compression;
using FastPoints.Cli.Preview;

namespace FastPoints.Cli.Page;

/// <summary>What a page's 3D view shows: points in waves as a preview takes them, quantised, and a camera or a way of
/// one.</summary>
sealed class ViewCloud
{
    public const int MaxPoints = 400_000;
    const int Steps = 65_535;

    /// <summary>Of base 64.</summary>
    const double BytesOfLetters = 4 / 3.0;

    const double FarBounds = 4;

    readonly List<ViewPoints> m_sets = [];
    readonly PictureOptions m_options;
    List<ViewColumn> m_columns = [];

    ViewCloud(PictureOptions options, DisplayRanges ranges) => (m_options, Ranges) = (options, ranges);

    public DisplayRanges Ranges { get; }
    public string Unit => Human.Unit(Ranges.Units.Horizontal);
    public List<ViewWave> Waves { get; } = [];

    /// <summary>What is shown: everything, or what nearly all points are in where few far ones would leave it too few
    /// steps.</summary>
    public BoundsGeo Bounds { get; private set; } = new(new double3(0, 0, 0), new double3(1, 1, 1));

    public ViewPoints Points => m_sets[^1];
    public double Spacing { get; private set; }
    public required Camera Camera { get; init; }
    public (List<Camera> Cameras, int Every)? Path { get; init; }
    public double3 PositionError => Bounds.Size / Steps / 2;

    public static ViewCloud Take(Func<PointReader> open, PictureOptions options, Camera camera, CliRun run)
    {
        var preview = new PreviewOptions { Points = MaxPoints, Picture = options };
        using var reader = open();
        using var taken = new SampleMethods(() => WithAll(open()), preview, run) { Runs = 1 }.Ours();
        var errors = WaveErrors.Measure(reader, taken, run);
        var view = new ViewCloud(options, new DisplayRanges { Units = reader.Info.Crs.Units }) { Camera = camera };
        for (int i = 0; i < taken.Waves.Count; i++)
        {
            var (wave, points) = taken.Waves[i];
            bool isLastOfBatch = i + 1 == taken.Waves.Count || taken.Waves[i + 1].Points != points;
            view.Waves.Add(new ViewWave(view.m_sets.Count, wave.Points, wave.Seconds, wave.BytesRead, errors[i]));
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
            using var batch = Load(cloud, MaxPoints / clouds.Length, run, out var transform, out var units);
            var ranges = new DisplayRanges { Units = units };
            run.RunSteps(ranges.Measure(batch, transform, options.UpAxis));
            parts.Add(ViewPoints.Of(batch, batch.Count, transform));
            view ??= new ViewCloud(options, ranges) { Camera = cameras[0], Path = every > 0 ? (cameras, every) : null };
            if (ranges.Full.IsEmpty)
                continue;
            view.Ranges.Full = Around(view.Ranges.Full, ranges.Full);
            view.Ranges.Robust = Around(view.Ranges.Robust, ranges.Robust);
            view.Ranges.ElevationLow = Math.Min(view.Ranges.ElevationLow, ranges.ElevationLow);
            view.Ranges.ElevationHigh = Math.Max(view.Ranges.ElevationHigh, ranges.ElevationHigh);
        }
        view!.m_sets.Add(ViewPoints.Join(parts));
        view.Prepare();
        return view;
    }

    static BoundsGeo Around(BoundsGeo a, BoundsGeo b) => new(math.min(a.Min, b.Min), math.max(a.Max, b.Max));

    static PointBatch Load(string path, int max, CliRun run, out PositionTransform transform, out CloudUnits units)
    {
        if (!CloudFolder.IsCloud(path))
        {
            using var reader = WithAll(PointReaders.Open(path));
            using var sampler = Sampled(reader, max, run);
            (transform, units) = (reader.Info.Transform, reader.Info.Crs.Units);
            return sampler.TakeSample().Points;
        }
        using var folder = CloudFolder.Open(path);
        using var selection = new NodeSelection(folder);
        selection.Choose(null, max);
        var schema = LoadNodes.SchemaFor(folder, folder.Manifest.Attributes.Select(a => a.Name).ToArray());
        var batch = new PointBatch(schema, checked((int)selection.Points), Allocator.Persistent);
        run.RunSteps(LoadNodes.Run(folder, selection, batch, null));
        transform = folder.Manifest.Grid.FromCorner(folder.Manifest.Root.Corner);
        units = folder.Manifest.Crs.Units;
        return batch;
    }

    static PreviewSampler Sampled(PointReader reader, int max, CliRun run)
    {
        if (!reader.BlocksAreKnown)
            run.RunSteps(reader.FindBlocks());
        var sampler = new PreviewSampler(reader, max, 1);
        run.RunSteps(sampler.Run(0, null));
        return sampler;
    }

    static PointReader WithAll(PointReader reader)
    {
        reader.Info.AlsoSampled = reader.Info.Schema.Select(a => a.Name).ToArray();
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
        List<int[]> kept;
        List<byte[]> packed;
        for (double share = 1; ; share *= 0.95 * maxBytes / (packed.Sum(p => p.Length) * BytesOfLetters))
        {
            // What lies far outside is left out: its places would leave too few for the rest.
            kept = m_sets.Select(s => Enumerable.Range(0, s.Count).Where(i =>
                (i == 0 || (long)(i * share) != (long)((i - 1) * share)) && IsInside(s[i])).ToArray()).ToList();
            packed = m_sets.Select((s, i) => Pack(s, kept[i])).ToList();
            shown = kept[^1].Length;
            if (packed.Sum(p => p.Length) * BytesOfLetters <= maxBytes || shown < 1000)
                return ToJson(kept, packed);
        }
    }

    string ToJson(List<int[]> kept, List<byte[]> packed)
    {
        var stream = new MemoryStream((int)(packed.Sum(p => p.Length) * BytesOfLetters) + 100_000);
        using (var json = new Utf8JsonWriter(stream))
        {
            json.WriteStartObject();
            WriteFrame(json, kept[^1].Length);
            json.WriteStartObject("ramps");
            foreach (var (name, gradient) in new[] { ("viridis", Gradient.Viridis), ("gray", Gradient.Gray) })
            {
                using var palette = Palettes.Create(ColorMode.Elevation, Allocator.Persistent, gradient);
                json.WriteString(name, string.Concat(palette.Select(ViewColumn.Hex)));
            }
            json.WriteEndObject();
            json.WriteStartArray("columns");
            foreach (var column in m_columns)
                column.Write(json, Points);
            json.WriteEndArray();
            json.WriteStartArray("sets");
            for (int i = 0; i < m_sets.Count; i++)
            {
                json.WriteStartObject();
                json.WriteNumber("count", kept[i].Length);
                json.WriteBase64String("data", packed[i]);
                json.WriteEndObject();
            }
            json.WriteEndArray();
            json.WriteStartArray("waves");
            foreach (var wave in Waves)
            {
                json.WriteStartObject();
                json.WriteNumber("set", wave.Set);
                json.WriteNumber("shown", kept[wave.Set].Count(i => i < wave.Points));
                json.WriteString("text", Describe(wave));
                json.WriteEndObject();
            }
            json.WriteEndArray();
            json.WriteEndObject();
        }
        return Encoding.UTF8.GetString(stream.GetBuffer(), 0, (int)stream.Length);
    }

    public string Describe(ViewWave wave) => Human.Count(wave.Points, "point") + " after " + Human.Seconds(wave.Seconds)
        + (Ranges.IsInDegrees || double.IsNaN(wave.Rms) ? "" : ": RMS error " + Human.FourDigits(wave.Rms) + " " + Unit);

    bool IsInside(double3 geo) => math.all(geo >= Bounds.Min) && math.all(geo <= Bounds.Max);

    void WriteFrame(Utf8JsonWriter json, int shown)
    {
        m_options.UpAxis.Directions(out var east, out var north, out var up);
        var mode = Ranges.Resolve(m_options.Color);
        string name = mode == ColorMode.Rgb ? "Colour" : ColorModes.AttributeOf(mode) ?? "";
        double step = math.cmax(Bounds.Size) / Steps;
        json.WriteVector("origin", Bounds.Min);
        json.WriteVector("size", Bounds.Size);
        json.WriteVector("lengths", Ranges.LengthsPerUnit);
        json.WriteNumber("up", m_options.UpAxis.Index());
        json.WriteStartArray("axes");
        foreach (var axis in new[] { east, north, up })
            Write(json, axis);
        json.WriteEndArray();
        json.WriteString("unit", Unit);
        json.WriteNumber("decimals", step > 0 ? Math.Clamp((int)Math.Ceiling(-Math.Log10(step)), 0, 8) : 3);
        // A little larger than their distance: what is askew would have holes.
        json.WriteNumber("spacing", 2 * Spacing * Math.Sqrt(Points.Count / Math.Max(1.0, shown)));
        json.WriteNumber("mode", m_columns.FindIndex(c => c.Name == name));
        json.WriteBoolean("shaded", mode != ColorMode.Rgb);
        json.WriteStartArray("elevation");
        json.WriteNumberValue(Ranges.ElevationLow);
        json.WriteNumberValue(Ranges.ElevationHigh);
        json.WriteEndArray();
        Write(json, "camera", Camera);
        if (Path is not { } path)
            return;
        json.WriteStartObject("path");
        json.WriteNumber("every", path.Every);
        json.WriteStartArray("cameras");
        foreach (var camera in path.Cameras)
            Write(json, null, camera);
        json.WriteEndArray();
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

    /// <summary>Columns as differences from point to point, low and high bytes apart, deflated.</summary>
    byte[] Pack(ViewPoints points, int[] kept)
    {
        var packed = new MemoryStream();
        using (var deflate = new ZLibStream(packed, CompressionLevel.Optimal))
        {
            for (int axis = 0; axis < 3; axis++)
            {
                double low = Bounds.Min[axis], size = Bounds.Size[axis];
                double perStep = size > 0 ? Steps / size : 0;
                byte[] lows = new byte[kept.Length], highs = new byte[kept.Length];
                int before = 0;
                for (int i = 0; i < kept.Length; i++)
                {
                    int place = (int)Math.Round((points.Positions[axis][kept[i]] - low) * perStep);
                    (lows[i], highs[i]) = ((byte)(place - before), (byte)(place - before >> 8));
                    before = place;
                }
                deflate.Write(lows);
                deflate.Write(highs);
            }
            foreach (byte[] plane in m_columns.SelectMany(c => c.Planes(points, kept)))
            {
                for (int i = plane.Length - 1; i > 0; i--)
                    plane[i] -= plane[i - 1];
                deflate.Write(plane);
            }
        }
        return packed.ToArray();
    }
}
