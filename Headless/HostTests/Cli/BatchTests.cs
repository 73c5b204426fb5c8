namespace FastPoints.HostTests.Cli;

public sealed class BatchTests : ScratchPerTest
{
    string m_demo, m_bad;

    [SetUp]
    public void MakeClouds()
    {
        m_demo = Scratch.Demo("a.las", 500);
        m_bad = Scratch["bad.las"];
        File.WriteAllText(m_bad, "LASF");
    }

    static void HasOutcomes(CliCall call, params int[] wanted)
    {
        Assert.That(call.Status, Is.EqualTo(wanted.Contains(3) ? ExitStatus.BadInput : ExitStatus.Done), call.Error);
        var files = call.Json.GetProperty("files");
        Assert.That(files.EnumerateArray().Select(f => f.GetProperty("status").GetInt32()), Is.EqualTo(wanted));
        foreach (var file in files.EnumerateArray())
        {
            bool isBad = file.GetProperty("status").GetInt32() != 0;
            Assert.That(file.GetProperty("input").ValueKind, Is.EqualTo(JsonValueKind.String));
            Assert.That(file.TryGetProperty("failure", out var failure), Is.EqualTo(isBad));
            if (isBad)
                Assert.That(failure.GetProperty("message").GetString(), Does.StartWith(file.GetProperty("input").GetString()));
        }
    }

    [Test]
    public void Info_WithABadFile_Continues()
    {
        var call = CliCall.Of("info", m_demo, m_bad, m_demo, "--json", "-");
        HasOutcomes(call, 0, 3, 0);
        Assert.That(call.ErrorLines, Is.EqualTo(1), call.Error);
        Assert.That(call.Json.GetProperty("files")[2].GetProperty("points").GetInt64(), Is.EqualTo(500));
        Assert.That(call.Json.GetProperty("failure").GetProperty("file").GetString(), Is.EqualTo(m_bad));
    }

    [Test]
    public void Info_OfOneFile_HasItsKeysAtTheTopAndInTheList()
    {
        var call = CliCall.Of("info", m_demo, "--json", "-");
        HasOutcomes(call, 0);
        Assert.That(call.Json.GetProperty("files")[0].GetProperty("format").GetString(), Is.EqualTo("LAS"));
        Assert.That(call.Json.GetProperty("format").GetString(), Is.EqualTo("LAS"));
        HasOutcomes(CliCall.Of("info", m_bad, "--json", "-"), 3);
    }

    [Test]
    public void MainJob_WithABadFile_Continues()
    {
        string other = Scratch.Demo("b.las", 500), reports = Scratch["reports"];
        var call = CliCall.Of(m_bad, m_demo, other, "-o", reports, "--json", "-");
        HasOutcomes(call, 3, 0, 0);
        Assert.That(Directory.GetDirectories(reports).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "a-report", "b-report" }));
        Assert.That(call.Json.GetProperty("files")[2].GetProperty("report").GetString(),
            Is.EqualTo(Path.Combine(reports, "b-report", "report.html")));
    }

    [Test]
    public void MainJob_OfFilesOfOneName_WritesAReportForEach()
    {
        string laz = Scratch.Demo("a.laz", 600);
        Directory.CreateDirectory(Scratch["sub"]);
        File.Copy(m_demo, Scratch["sub/a.las"]);
        HasOutcomes(CliCall.Of(m_demo, laz, Scratch["sub/a.las"], "-o", Scratch["r"], "--json", "-"), 0, 0, 0);
        Assert.That(Directory.GetDirectories(Scratch["r"]).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "a.las-report", "a.laz-report", "a.las-report-2" }));
    }

    [Test]
    public void MainJob_OverAReportOfAnotherFile_NeedsForce()
    {
        string laz = Scratch.Demo("a.laz", 600), folder = Scratch["r"];
        Assert.That(CliCall.Of(m_demo, "-o", folder).Status, Is.Zero);
        byte[] page = File.ReadAllBytes(Path.Combine(folder, "report.html"));
        var refused = CliCall.Of(laz, "-o", folder);
        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(refused.Error, Does.Contain(m_demo).And.Contain("--force"));
        Assert.That(File.ReadAllBytes(Path.Combine(folder, "report.html")), Is.EqualTo(page));
        Assert.That(CliCall.Of(m_demo, "-o", folder).Status, Is.Zero, "the same file's own is written again");
        Assert.That(CliCall.Of(laz, "-o", folder, "--force").Status, Is.Zero);
        var facts = JsonDocument.Parse(File.ReadAllBytes(Path.Combine(folder, "report.json"))).RootElement;
        Assert.That(facts.GetProperty("input").GetString(), Is.EqualTo(laz));
        Assert.That(facts.GetProperty("convert").GetProperty("points").GetInt64(), Is.EqualTo(600));
    }
}
