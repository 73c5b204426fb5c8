using FastPoints.Cli.Surfaces;

namespace FastPoints.Cli.Verbs;

public sealed class SurfaceVerb : Verb
{
    const int CellEdgeVoxels = 80;

    readonly Argument<string> m_cloud = new("NAME.fastpoints") { Description = "A converted cloud." };
    readonly ValueOption<string> m_output = new("--output", "S.ply|.obj",
        "The file to write: thin sheets with two faces where the points are, in the cloud's coordinates, binary PLY or OBJ. "
            + "All of it is kept in memory, some 100 bytes a triangle.")
    { Aliases = { "-o" }, Required = true };
    readonly ValueOption<double> m_voxel = new("--voxel", "METRES",
        "Edge of a voxel: about the size of triangles, and how far points of one surface may be from one another.", 0.1);
    readonly ValueOption<double?> m_hole = new("--hole", "METRES",
        "The widest holes to close, at most 8 voxels (default: 3 voxels).");
    readonly ValueOption<string[]> m_clip = new("--clip", "x,y,z,X,Y,Z",
        "Only points in the box between two corners in the cloud's coordinates, faces included, or in any of several.");
    readonly ValueOption<string[]> m_cut = new("--cut", "x,y,z,X,Y,Z", "No points in the box.");
    readonly FilterSettings m_filter;

    public SurfaceVerb() : base(new Command("surface",
        "A surface of a converted cloud's points as triangles: for physics, navigation and other programs."))
    {
        Command.Add(m_cloud, m_output, m_voxel, m_hole, m_clip, m_cut);
        m_filter = new FilterSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints surface street.fastpoints -o street.ply", "in voxels of 10 cm"),
        ("./fastpoints surface town.fastpoints -o ground.obj --voxel 0.5 --classes 2,6,9", "ground, buildings and water alone"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string cloud = Path.TrimEndingDirectorySeparator(parsed.GetRequiredValue(m_cloud));
        string output = parsed.GetRequiredValue(m_output);
        if (StandardStreams.IsOutput(output) || !SurfaceFile.CanWrite(output))
            throw new UsageException("--output: wanted a name that ends in .ply or .obj, got " + output);
        if (Directory.Exists(output))
            throw new UsageException("--output: this is a folder: " + output);
        var grid = GridOf(parsed);
        run.Begin([cloud], output);
        if (!CloudFolder.IsCloud(cloud))
            throw new PointCloudException(FailureCode.Unsupported, cloud, -1,
                "wanted a converted cloud: ./fastpoints convert makes one");
        EditVerb.WarnIfEdited([cloud], run);
        using var reader = ConvertedReader.Open(cloud);
        using var filter = FilterOf(parsed, reader);
        using var step = new SurfaceStep(cloud, grid, filter, run);
        run.RunSteps(step.Run());
        var vertices = step.VerticesGeo();
        run.Progress.Begin("write");
        SurfaceFile.Write(output, vertices, step.Triangles, step.StepGeo, run.Cancellation);
        run.Progress.End();
        run.Points.Add(reader.Info, reader.PointCount);
        if (step.Points == 0 && reader.PointCount > 0)
            run.WarnEmpty(output, "left", reader.PointCount, reader.Info.BoundsClaimed, []);
        WriteResult(output, step, vertices.Count, run);
    }

    SurfaceGrid GridOf(ParseResult parsed)
    {
        double voxel = parsed.GetValue(m_voxel), hole = parsed.GetValue(m_hole) ?? 3 * voxel;
        if (!(voxel > 0 && voxel <= 1e6))
            throw new UsageException("--voxel: wanted a length above 0");
        if (!(hole >= 0 && hole <= SurfaceGrid.MaxHoleVoxels * voxel))
            throw new UsageException("--hole: wanted 0 to " + SurfaceGrid.MaxHoleVoxels + " voxels, which are "
                + NumberFormat.Value(SurfaceGrid.MaxHoleVoxels * voxel) + " m");
        return new SurfaceGrid(voxel, CellEdgeVoxels, (float)(hole / voxel));
    }

    PointFilter? FilterOf(ParseResult parsed, PointReader reader)
    {
        var filter = m_filter.Read(parsed, reader) ?? new PointFilter();
        if (filter.EveryNth > 1)
        {
            filter.Dispose();
            throw new UsageException("--every-nth: a converted cloud has its points in another order");
        }
        filter.Clips =
        [
            .. (parsed.GetValue(m_clip) ?? []).Select(box => Clip("--clip", box, false)),
            .. (parsed.GetValue(m_cut) ?? []).Select(box => Clip("--cut", box, true)),
        ];
        if (!filter.IsEmpty)
            return filter;
        filter.Dispose();
        return null;
    }

    static LocalClip Clip(string option, string box, bool cuts) =>
        new(PictureSettings.Box(option, box, cuts), new CloudPlacement(double3x3.identity, default));

    static void WriteResult(string output, SurfaceStep step, int vertices, CliRun run)
    {
        double? At(double share) => step.Distances.Count == 0 ? null
            : step.Distances[Math.Min(step.Distances.Count - 1, (int)(share * step.Distances.Count))];
        long bytes = OutputFile.IsDevice(output) ? 0 : new FileInfo(output).Length;
        run.WriteKeys = json =>
        {
            json.WriteInteger("points", step.Points);
            json.WriteInteger("cells", step.CellCount);
            json.WriteInteger("triangles", step.Triangles.Count);
            json.WriteInteger("vertices", vertices);
            json.WriteInteger("bytes", bytes);
            json.WriteStartObject("distance");
            json.WriteReal("p50", At(0.5) ?? double.NaN);
            json.WriteReal("p95", At(0.95) ?? double.NaN);
            json.WriteReal("max", At(1) ?? double.NaN);
            json.WriteEndObject();
        };
        run.Out.WriteLine(output + ": " + NumberFormat.Count(step.Triangles.Count, "triangle") + ", "
            + NumberFormat.Bytes(bytes) + (At(0.95) is { } far ? ", 95 % of the points within " + NumberFormat.Value(far) + " m"
            : ""));
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }
}
