namespace FastPoints.Cli.Stability;

public static class StabilityTable
{
    public const int DefaultPoints = 200_000;

    static readonly string[] s_stages = ["read", "preview", "build", "draw", "stream", "card"];

    public static void Run(int points, CliRun run)
    {
        string scratch = Directory.CreateTempSubdirectory("fastpoints-stability-").FullName;
        var results = new List<StabilityRun>();
        run.WriteKeys = json =>
        {
            json.WriteObjects("cases", results, result =>
            {
                json.WriteString("name", result.Name);
                json.WriteBoolean("ok", result.Problems.Count == 0);
                foreach (var stage in result.Stages)
                {
                    json.WriteStartObject(stage.Stage);
                    json.WriteString("outcome", stage.Outcome);
                    json.WriteReal("error", stage.Error);
                    json.WriteReal("seconds", stage.Seconds);
                    json.WriteInteger("residentBytes", stage.ResidentBytes);
                    json.WriteEndObject();
                }
            });
        };
        try
        {
            foreach (var stabilityCase in StabilityCases.All)
                results.Add(StabilityRun.Run(stabilityCase, points, scratch, Sampler.Poisson));
        }
        finally
        {
            Directory.Delete(scratch, recursive: true);
        }
        // Markdown, for the documentation.
        run.Out.WriteLine("| case | " + string.Join(" | ", s_stages) + " | resident | holds |");
        run.Out.WriteLine("|---|" + string.Concat(Enumerable.Repeat("---|", s_stages.Length + 2)));
        foreach (var result in results)
        {
            var cells = s_stages.Select(s => Describe(result.Stages.FirstOrDefault(r => r.Stage == s)));
            run.Out.WriteLine("| " + result.Name + " | " + string.Join(" | ", cells) + " | "
                + NumberFormat.Bytes(result.Stages.Max(s => s.ResidentBytes)) + " | "
                + (result.Problems.Count == 0 ? "yes" : "NO") + " |");
        }
        if (!HeadlessGraphics.IsAvailable)
            run.Out.WriteLine("card: not drawn: " + HeadlessGraphics.UnsupportedReason);
        foreach (var result in results)
            foreach (string problem in result.Problems)
                run.Out.WriteLine(result.Name + ": " + problem);
        if (results.Any(r => r.Problems.Count > 0))
            throw new PointCloudException(FailureCode.BadInput, "stability", -1, results.Count(r => r.Problems.Count > 0)
                + " cases do not hold");
    }

    static string Describe(StabilityRun.StageResult? stage)
    {
        if (stage == null)
            return "";
        string error = stage.Error == 0 ? "" : stage.Stage is "preview" or "draw" or "stream"
            ? ", " + (100 * stage.Error).ToString("0.##", CultureInfo.InvariantCulture) + " % bare"
            : stage.Stage == "card" ? ", " + (100 * stage.Error).ToString("0.###", CultureInfo.InvariantCulture) + " % differ"
            : ", " + stage.Error.ToString("0", CultureInfo.InvariantCulture) + " points wrong";
        return stage.Outcome + error + ", " + NumberFormat.Seconds(stage.Seconds);
    }
}
