namespace FastPoints.Cli.Verbs;

public sealed class EditVerb : Verb
{
    readonly Argument<string> m_cloud = new("CLOUD") { Description = "A converted cloud, NAME.fastpoints; it stays as it is." };
    readonly ValueOption<string[]> m_clip = new("--clip", "x,y,z,X,Y,Z",
        "Only points in the box between two corners in the cloud's coordinates, faces included, or in any of several.");
    readonly ValueOption<string[]> m_sphere = new("--sphere", "x,y,z,R", "Only points in the sphere, or in any of several.");
    readonly ValueOption<string?> m_lasso = new("--lasso", "x,y,z,...",
        "Only points that an eye, the first position, sees through the polygon of the others, at any depth.");
    readonly FilterSettings m_filter;
    readonly Flag m_hide = new("--hide", "Do not show these points; export and convert keep them.");
    readonly Flag m_delete = new("--delete", "Leave these points out from now on.");
    readonly ValueOption<string?> m_classify = new("--classify", "N", "Give them this class.");
    readonly ValueOption<string?> m_colour = new("--colour", "R,G,B", "Give them this colour, each of 0 to 255.");
    readonly Flag m_list = new("--list", "Say what was done.");
    readonly Flag m_undo = new("--undo", "Undo the last of what was done.");
    readonly Flag m_redo = new("--redo", "Do again what was undone last.");
    readonly List<Option> m_actions, m_choices;

    public EditVerb() : base(new Command("edit", "Hide, delete, classify or colour points of a converted cloud, and undo it: "
        + "NAME.fastpoints.edits has it, beside the cloud."))
    {
        Command.Add(m_cloud);
        m_actions = [m_hide, m_delete, m_classify, m_colour, m_list, m_undo, m_redo];
        foreach (var action in m_actions)
            Command.Add(action);
        int before = Command.Options.Count;
        Command.Add(m_clip, m_sphere, m_lasso);
        m_filter = new FilterSettings(Command);
        m_choices = [.. Command.Options.Skip(before)];
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints edit scan.fastpoints --delete --where 'Classification == 7'", "noise is gone, until it is undone"),
        ("./fastpoints edit scan.fastpoints --classify 6 --polygon roofs.geojson --where 'Z > 40'", "roofs become buildings"),
        ("./fastpoints edit scan.fastpoints --hide --clip 0,0,0,5,5,3 --sphere 9,9,0,2", "what is in both"),
        ("./fastpoints edit scan.fastpoints --undo", "the last one"),
        ("./fastpoints edit scan.fastpoints --list --json -", "for a script"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string cloud = Path.TrimEndingDirectorySeparator(parsed.GetRequiredValue(m_cloud));
        var given = m_actions.Where(a => parsed.GetResult(a) is { Implicit: false }).ToList();
        if (given is not [var action])
            throw new UsageException("wanted one of " + string.Join(", ", m_actions.Select(a => a.Name)) + ", got "
                + (given.Count == 0 ? "none" : string.Join(", ", given.Select(a => a.Name))));
        bool isChange = action != m_list && action != m_undo && action != m_redo;
        if (m_choices.Any(c => parsed.GetResult(c) is { Implicit: false }) != isChange)
            throw new UsageException(action.Name + (isChange ? ": wanted which points: "
                + string.Join(", ", m_choices.Select(c => c.Name)) : " takes no choice of points"));
        run.Begin([cloud]);
        if (!CloudFolder.IsCloud(cloud))
            throw new PointCloudException(FailureCode.Unsupported, cloud, -1,
                "wanted a converted cloud: ./fastpoints convert makes one");
        using var reader = ConvertedReader.Open(cloud);
        EditOperation? done = null;
        if (isChange)
        {
            done = Read(parsed, reader);
            run.RunSteps(EditCloud.Run(cloud, done, run.Progress));
            if (done.PointsChanged == 0)
                run.Warn(cloud + ": no point is changed, and nothing is written down");
        }
        else if (action != m_list)
        {
            done = Step(cloud, reader.Manifest.CloudId, action == m_undo)
                ?? throw new UsageException(action.Name + ": there is nothing to " + action.Name.TrimStart('-'));
        }
        var journal = EditJournal.Read(cloud, reader.Manifest.CloudId);
        run.WriteKeys = json => WriteKeys(json, journal, done);
        Write(run.Out, cloud, journal, done, action.Name.TrimStart('-'));
    }

    /// <returns>The last operation, which is undone or done again; null if there is none.</returns>
    static EditOperation? Step(string cloud, ulong cloudId, bool isUndo)
    {
        using var held = EditCloud.Lock(cloud);
        var journal = EditJournal.Read(cloud, cloudId);
        return isUndo ? journal.TryUndo() ? journal.Operations[journal.Count] : null
            : journal.TryRedo() ? journal.Operations[journal.Count - 1] : null;
    }

    EditOperation Read(ParseResult parsed, ConvertedReader reader)
    {
        var operation = new EditOperation
        {
            CloudId = reader.Manifest.CloudId,
            Action = parsed.GetValue(m_delete) ? EditAction.Delete : parsed.GetValue(m_hide) ? EditAction.Hide
                : parsed.GetValue(m_colour) != null ? EditAction.Color : EditAction.Classify,
        };
        if (parsed.GetValue(m_classify) is { } number)
            operation.Value = Bytes("--classify", "a number", 1, number);
        if (parsed.GetValue(m_colour) is { } colour)
            operation.Value = Bytes("--colour", "R,G,B, each", 3, colour);
        var grid = reader.Manifest.Grid;
        foreach (string box in parsed.GetValue(m_clip) ?? [])
        {
            var clip = PictureSettings.Box("--clip", box, false);
            var half = new double3(clip.EdgesWorld.c0.x, clip.EdgesWorld.c1.y, clip.EdgesWorld.c2.z) / 2;
            operation.Boxes.Add(EditShape.Box(grid, clip.CenterWorld - math.abs(half), clip.CenterWorld + math.abs(half)));
        }
        foreach (string sphere in parsed.GetValue(m_sphere) ?? [])
        {
            double[] of = PictureSettings.ParseNumbers(sphere);
            if (of.Length != 4 || of[3] < 0)
                throw new UsageException("--sphere: wanted x,y,z,R, got " + sphere);
            operation.Balls.Add(Ball(grid, new double3(of[0], of[1], of[2]), of[3]));
        }
        using var filter = m_filter.Read(parsed, reader);
        if (filter?.EveryNth > 1)
            throw new UsageException("--every-nth: an edit does not depend on the order of points");
        operation.Conditions.AddRange(filter?.Expressions ?? []);
        if (parsed.GetValue(m_lasso) is { } lasso)
            AddLasso(operation, grid, lasso, filter?.Polygons != null);
        AddPolygons(operation, filter?.Polygons, grid);
        return EditPlan.FindProblem(operation, reader.Manifest) is { } problem
            ? throw new PointCloudException(FailureCode.Unsupported, reader.Info.ShownPath, -1, problem) : operation;
    }

    // The centre lies on the nearest grid position.
    internal static EditShape Ball(in CloudGrid grid, double3 center, double radius)
    {
        var ball = new EditShape
        {
            A = EditShape.GridOf(math.round((center - grid.Origin) / grid.Step)),
            B = EditShape.GridOf(math.floor(radius / grid.Step * (1 + 4.5e-16))),
            IsBall = true,
        };
        if (!ball.IsRound)
            ball.B = Grid3.Max(ball.B, new Grid3(1, 1, 1));
        return ball;
    }

    static void AddLasso(EditOperation operation, CloudGrid grid, string lasso, bool hasPolygons)
    {
        double[] of = PictureSettings.ParseNumbers(lasso);
        var positions = Enumerable.Range(0, of.Length / 3).Select(i => new double3(of[3 * i], of[3 * i + 1], of[3 * i + 2]));
        if (of.Length % 3 != 0 || of.Length == 0 || hasPolygons ||
            operation.SetLasso(grid, new double4(positions.First(), 1), positions.Skip(1).ToList()) is not null)
            throw new UsageException("--lasso: wanted an eye, three positions or more around what it sees, no polygons; got "
                + lasso);
    }

    /// <summary>As a prism along Z; vertices lie on the nearest part of the grid's steps.</summary>
    static void AddPolygons(EditOperation operation, FilterPolygons? polygons, CloudGrid grid)
    {
        if (polygons == null)
            return;
        ref var prism = ref operation.Prism;
        prism.Origin = EditShape.GridOf(math.floor((new double3(polygons.Min, 0) - grid.Origin) / grid.Step));
        prism.U = new Grid3(EditPrism.SubstepsPerStep, 0, 0);
        prism.V = new Grid3(0, EditPrism.SubstepsPerStep, 0);
        var from = grid.ToGeo(prism.Origin);
        foreach (var (polygon, vertices) in polygons.Rings)
            operation.AddRing(polygon, [.. vertices.SelectMany(vertex =>
            {
                var at = EditShape.GridOf(math.round((new double3(vertex, 0) - from) / grid.Step * EditPrism.SubstepsPerStep));
                return new[] { at.X, at.Y };
            })]);
    }

    static byte[] Bytes(string option, string what, int count, string text)
    {
        double[] of = PictureSettings.ParseNumbers(text);
        return of.Length == count && of.All(c => c is >= 0 and <= byte.MaxValue && c == Math.Floor(c))
            ? [.. of.Select(c => (byte)c)]
            : throw new UsageException(option + ": wanted " + what + " of 0 to 255, got " + text);
    }

    static void WriteKeys(Utf8JsonWriter json, EditJournal journal, EditOperation? done)
    {
        if (done != null)
            json.WriteInteger("pointsChanged", done.PointsChanged);
        else
            json.WriteNull("pointsChanged");
        json.WriteObjects("operations", Enumerable.Range(0, journal.Operations.Count), i =>
        {
            var operation = journal.Operations[i];
            json.WriteString("do", operation.Name);
            if (operation.Action == EditAction.Classify)
                json.WriteNumber("class", operation.Value[0]);
            if (operation.Action == EditAction.Color)
                json.WriteArray("colour", operation.Value, value => json.WriteNumberValue(value));
            json.WriteNumber("boxes", operation.Boxes.Count);
            json.WriteNumber("spheres", operation.Balls.Count);
            json.WriteNumber("rings", operation.Rings.Count);
            json.WriteArray("where", operation.Conditions, condition => json.WriteStringValue(condition.Text));
            json.WriteInteger("pointsChanged", operation.PointsChanged);
            json.WriteBoolean("undone", i >= journal.Count);
        });
    }

    static void Write(TextWriter writer, string cloud, EditJournal journal, EditOperation? done, string action)
    {
        writer.WriteLine(cloud + ": " + (done == null ? NumberFormat.Count(journal.Count, "edit")
            : action + ", " + NumberFormat.Count(done.PointsChanged, "point")));
        for (int i = 0; i < journal.Operations.Count && done == null; i++)
            writer.WriteLine("  " + NumberFormat.Count(i + 1).PadLeft(3) + "  " + Describe(journal.Operations[i])
                + (i >= journal.Count ? " (undone)" : ""));
    }

    static string Describe(EditOperation operation)
    {
        var parts = new List<string>();
        if (operation.Boxes.Count > 0)
            parts.Add("in " + NumberFormat.Count(operation.Boxes.Count) + (operation.Boxes.Count == 1 ? " box" : " boxes"));
        if (operation.Balls.Count > 0)
            parts.Add("in " + NumberFormat.Count(operation.Balls.Count, "sphere"));
        if (operation.Prism.IsPyramid)
            parts.Add("in a lasso");
        else if (operation.Rings.Count > 0)
            parts.Add("in polygons of " + NumberFormat.Count(operation.Rings.Count, "ring"));
        parts.AddRange(operation.Conditions.Select(c => "where " + c.Text));
        string what = string.Join(" ", operation.Name, string.Join(",", operation.Value)).TrimEnd();
        return what + " " + string.Join(", ", parts) + ": " + NumberFormat.Count(operation.PointsChanged, "point");
    }
}
