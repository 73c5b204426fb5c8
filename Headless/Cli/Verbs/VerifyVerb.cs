namespace FastPoints.Cli.Verbs;

public sealed class VerifyVerb : Verb
{
    readonly Argument<string> m_cloud = new("NAME.fastpoints") { Description = "A converted cloud." };
    readonly ValueOption<string[]> m_against = new("--against", "FILE...",
        "The files (or their folder) that it was made from: the points are the same, position and every attribute, or it "
            + "fails.")
    { Arity = ArgumentArity.OneOrMore, AllowMultipleArgumentsPerToken = true };

    readonly SourceSettings m_source;

    public VerifyVerb() : base(new Command("verify",
        "Read every byte of a converted cloud: structure, hashes, each point in its cube, counts."))
    {
        Command.Add(m_cloud, m_against);
        m_source = new SourceSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints verify scan.fastpoints", "is it whole?"),
        ("./fastpoints verify scan.fastpoints --against scan.las", "is it the same?"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string cloud = parsed.GetRequiredValue(m_cloud);
        run.Begin([cloud]);
        var result = new VerifyResult();
        var readers = new List<PointReader>();
        var spacings = new List<LevelSpacing>();
        run.WriteKeys = json => WriteKeys(json, result, spacings);
        try
        {
            if (parsed.GetValue(m_against) is { Length: > 0 } files)
            {
                files = run.Begin(files);
                readers.Add(PointReaders.Open(files, m_source.Read(parsed)));
                run.Warn(readers[0].Info);
            }
            run.RunSteps(VerifyCloud.Run(cloud, readers, result, run.Progress));
            if (result.Ok)
                run.RunSteps(MeasureSpacing.Run(cloud, spacings));
            foreach (var reader in readers)
                run.Points.Add(reader.Info, reader.BlocksAreKnown ? reader.PointCount : reader.Info.PointsReadable);
        }
        finally
        {
            readers.ForEach(r => r.Dispose());
        }

        foreach (string problem in result.Problems)
            run.Out.WriteLine(problem);
        if (result.ProblemCount > result.Problems.Count)
            run.Out.WriteLine("and " + NumberFormat.Count(result.ProblemCount - result.Problems.Count) + " more");
        var table = new TextTable("level", "nodes", "points", "spacing", "minimum distance", "across chunks", "share too near");
        for (int level = 0; level < result.Levels.Count; level++)
        {
            var at = result.Levels[level];
            var near = SpacingOf(spacings, level);
            if (at.Nodes > 0)
                table.Add(NumberFormat.Count(level), NumberFormat.Count(at.Nodes), NumberFormat.Count(at.Points),
                    at.Spacing > 0 ? NumberFormat.Value(at.Spacing) : "",
                    double.IsFinite(near.MinDistance) ? NumberFormat.Value(near.MinDistance) : "",
                    double.IsFinite(near.MinDistanceAcrossChunks) ? NumberFormat.Value(near.MinDistanceAcrossChunks) : "",
                    at.SampledPoints > 0
                        ? NumberFormat.Value(Math.Round(100.0 * near.NearAcrossChunks / at.SampledPoints, 3)) + " %"
                        : "");
        }
        table.Write(run.Out, "  ");
        if (!result.Ok)
            throw new PointCloudException(FailureCode.BadInput, cloud, -1,
                result.ProblemCount == 1 ? "1 problem" : NumberFormat.Count(result.ProblemCount) + " problems");
        run.Out.WriteLine(cloud + ": " + NumberFormat.Count(result.Points)
            + (result.IsBuilding ? " points so far (it is being built), all there" : " points, all there")
            + (readers.Count > 0 ? ", the same as in the source" : ""));
    }

    // Levels of leaves alone have no spacing; that of a damaged cloud is not measured.
    static LevelSpacing SpacingOf(List<LevelSpacing> spacings, int level) =>
        level < spacings.Count ? spacings[level] : LevelSpacing.None;

    static void WriteKeys(Utf8JsonWriter json, VerifyResult result, List<LevelSpacing> spacings)
    {
        json.WriteBoolean("ok", result.Ok);
        json.WriteArray("problems", result.Problems, json.WriteStringValue);
        json.WriteInteger("points", result.Points);
        var withNodes = Enumerable.Range(0, result.Levels.Count).Where(level => result.Levels[level].Nodes > 0);
        json.WriteObjects("levels", withNodes, level =>
        {
            var at = result.Levels[level];
            var near = SpacingOf(spacings, level);
            json.WriteInteger("level", level);
            json.WriteInteger("nodes", at.Nodes);
            json.WriteInteger("points", at.Points);
            WriteLength(json, "spacing", at.Spacing > 0 ? at.Spacing : double.NaN);
            WriteLength(json, "minDistance", near.MinDistance);
            WriteLength(json, "minDistanceAcrossChunks", near.MinDistanceAcrossChunks);
            WriteLength(json, "shareNearAcrossChunks",
                at.SampledPoints > 0 ? near.NearAcrossChunks / (double)at.SampledPoints : double.NaN);
        });
    }

    static void WriteLength(Utf8JsonWriter json, string key, double value)
    {
        if (double.IsFinite(value))
            json.WriteReal(key, value);
        else
            json.WriteNull(key);
    }
}
