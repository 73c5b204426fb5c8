using Json.Schema;

namespace FastPoints.HostTests.Cli;

/// <summary>A call of the command line in this process. All summaries that it writes are held against their schema.</summary>
sealed class CliCall
{
    static readonly Lazy<JsonSchema> s_schema = new(() => JsonSchema.FromText(File.ReadAllText(
        Path.Combine(Checkout.Repository.PackageRoot, "Documentation~", "summary.schema.json"))));

    public int Status { get; private set; }
    public string Output { get; private set; }
    public string Error { get; private set; }

    public static CliCall Of(params string[] args) => Of(CancellationToken.None, args);

    public static CliCall Of(CancellationToken cancellation, params string[] args)
    {
        using var output = new StringWriter();
        using var error = new StringWriter();
        int status = CommandLine.Run(args, output, error, false, cancellation);
        int json = Array.LastIndexOf(args, "--json") + 1;
        string summary = json == 0 || json == args.Length ? "" : args[json] == "-" ? output.ToString()
            : File.Exists(args[json]) && status != ExitStatus.Usage ? File.ReadAllText(args[json]) : "";
        if (summary.Length > 0)
            Assert.That(Problems(summary), Is.Empty, string.Join(" ", args));
        return new CliCall { Status = status, Output = output.ToString(), Error = error.ToString() };
    }

    /// <summary>What of a summary is not as its schema says, by its place.</summary>
    public static List<string> Problems(string summary)
    {
        using var json = JsonDocument.Parse(summary);
        var found = s_schema.Value.Evaluate(json.RootElement, new EvaluationOptions { OutputFormat = OutputFormat.List });
        return found.IsValid ? [] : (found.Details ?? []).Where(d => d.Errors != null)
            .SelectMany(d => d.Errors.Select(e => d.InstanceLocation + ": " + e.Value)).ToList();
    }

    public JsonElement Json => JsonDocument.Parse(Output).RootElement;
    public int ErrorLines => Error.Split('\n', StringSplitOptions.RemoveEmptyEntries).Length;
}
