namespace FastPoints.HostTests.Cli;

public sealed class LostPointsTests : ScratchTests
{
    const int Points = 3000, RecordBytes = 36;

    string m_whole, m_short;

    [OneTimeSetUp]
    public void MakeClouds()
    {
        m_whole = Scratch.Demo("whole.las", Points);
        m_short = Scratch["short.las"];
        byte[] bytes = File.ReadAllBytes(m_whole);
        // The last thousand records are cut off.
        File.WriteAllBytes(m_short, bytes[..^(1000 * RecordBytes)]);
    }

    string[] Args(string file, string[] args) =>
        args.Select(a => a == "FILE" ? file : a.Replace("OUT", Scratch["out"], StringComparison.Ordinal)).ToArray();

    static readonly string[][] s_verbs =
    [
        ["info", "FILE"],
        ["info", "--scan", "FILE"],
        ["preview", "FILE", "-o", "OUT.png", "--size", "16x16"],
        ["picture", "FILE", "-o", "OUT.png", "--size", "16x16"],
        ["convert", "FILE", "-o", "OUT.fastpoints", "--force"],
        ["FILE", "-o", "OUT", "--force"],
    ];

    [TestCaseSource(nameof(s_verbs))]
    public void Source_Truncated_IsCountedAndIncompleteWithStrict(params string[] args)
    {
        var call = CliCall.Of(Args(m_short, args).Append("--force").Append("--json").Append("-").Append("--quiet").ToArray());
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Error, Is.Empty, "--quiet");
        var json = call.Json;
        Assert.That(json.GetProperty("pointsClaimed").GetInt64(), Is.EqualTo(Points));
        Assert.That(json.GetProperty("pointsFound").GetInt64(), Is.EqualTo(Points - 1000));
        Assert.That(json.GetProperty("pointsLost").GetInt64(), Is.EqualTo(1000));
        Assert.That(json.GetProperty("warnings").GetArrayLength(), Is.GreaterThan(0), "--quiet hides none here");

        var strict = CliCall.Of(Args(m_short, args).Append("--strict").Append("--json").Append("-").ToArray());
        Assert.That(strict.Status, Is.EqualTo(4));
        Assert.That(strict.Error, Does.Contain("1,000 points that are claimed are not there"));
        Assert.That(strict.Json.GetProperty("failure").GetProperty("code").GetString(), Is.EqualTo("Incomplete"));
    }

    [TestCaseSource(nameof(s_verbs))]
    public void Verb_WholeSource_LosesNothing(params string[] args)
    {
        var call = CliCall.Of(Args(m_whole, args).Append("--strict").Append("--force").Append("--json").Append("-").ToArray());
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("pointsFound").GetInt64(), Is.EqualTo(Points));
        Assert.That(call.Json.GetProperty("pointsLost").GetInt64(), Is.Zero);
    }

    [Test]
    public void Source_WithoutAClaim_HasNothingToLose()
    {
        File.WriteAllText(Scratch["a.txt"], "1 2 3\n4 5 6\n");
        var json = CliCall.Of("info", "--scan", Scratch["a.txt"], "--json", "-").Json;
        Assert.That(json.GetProperty("pointsClaimed").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(json.GetProperty("pointsFound").GetInt64(), Is.EqualTo(2));
        Assert.That(json.GetProperty("pointsLost").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }

    [Test]
    public void Garbage_Skipped_IsIncompleteWithStrict()
    {
        File.WriteAllText(Scratch["odd.ply"], "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            + "property float z\nend_header\n1 2 3\nnan 2 3\n4 5 6\n");
        string[] args = ["convert", Scratch["odd.ply"], "-o", Scratch["odd.fastpoints"], "--json", "-"];
        var call = CliCall.Of(args);
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("pointsLeftOut").GetInt64(), Is.EqualTo(1));
        Assert.That(call.Json.GetProperty("pointsFound").GetInt64(), Is.EqualTo(3));
        Assert.That(CliCall.Of(args.Append("--strict").ToArray()).Status, Is.EqualTo(4));
    }
}
