using Json.Schema;

namespace FastPoints.HostTests;

/// <summary>Holds all summaries that tests make against their schema.</summary>
[SetUpFixture]
public sealed class SummarySchema
{
    static readonly Lazy<JsonSchema> s_schema = new(() => JsonSchema.FromText(File.ReadAllText(
        Path.Combine(Checkout.Repository.PackageRoot, "Documentation~", "summary.schema.json"))));

    [OneTimeSetUp]
    public void Begin() => CliCall.SummaryWritten = (line, summary) => Assert.That(Problems(summary), Is.Empty, line);

    [OneTimeTearDown]
    public void End() => CliCall.SummaryWritten = null;

    /// <summary>What of a summary is not as its schema says, by its place.</summary>
    public static List<string> Problems(string summary)
    {
        using var json = JsonDocument.Parse(summary);
        var found = s_schema.Value.Evaluate(json.RootElement, new EvaluationOptions { OutputFormat = OutputFormat.List });
        return found.IsValid ? [] : (found.Details ?? []).Where(d => d.Errors != null)
            .SelectMany(d => d.Errors.Select(e => d.InstanceLocation + ": " + e.Value)).ToList();
    }
}
