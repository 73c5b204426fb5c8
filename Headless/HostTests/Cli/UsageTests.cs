namespace FastPoints.HostTests.Cli;

public sealed class UsageTests
{
    static readonly string[] s_verbs = { "info", "preview", "convert", "verify", "picture", "demo-cloud", "bench", "completion" };

    [Test]
    public void Help_OfTheMainJob_ListsEveryVerbWithExamplesAndExitStatus()
    {
        var call = CliCall.Of("--help");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done));
        foreach (string verb in s_verbs)
        {
            Assert.That(call.Output, Does.Contain("\n  " + verb + " "));
            Assert.That(call.Output, Does.Contain("./fastpoints " + verb + " "), "an example of " + verb);
        }
        Assert.That(call.Output, Does.Contain("Exit status: 0 done, 1 failed, 2 wrong usage, 3 the input is bad, 130 cancelled, "
            + "4 incomplete"));
        Assert.That(call.Error, Is.Empty);
    }

    [TestCaseSource(nameof(s_verbs))]
    public void Help_OfAVerb_HasUsageOptionsAndExamples(string verb)
    {
        var call = CliCall.Of(verb, "--help");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done));
        Assert.That(call.Output, Does.StartWith("usage: ./fastpoints " + verb));
        Assert.That(call.Output, Does.Contain("Examples:\n  ./fastpoints " + verb));
        foreach (string option in new[] { "--json FILE", "--threads N", "--quiet", "--force", "--strict" })
            Assert.That(call.Output, Does.Contain("  " + option));
    }

    [Test]
    public void Version_IsOneLine()
    {
        var call = CliCall.Of("--version");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done));
        Assert.That(call.Output.Trim(), Does.Match(@"^\d+\.\d+\.\d+"));
    }

    [TestCase("inof", "x.las", "info")]
    [TestCase("convret", "x.las", "convert")]
    [TestCase("hepl", "", "help")]
    [TestCase("info", "--scna", "--scan")]
    [TestCase("--jsn", "x.json", "--json")]
    public void Word_Misspelt_GetsASuggestion(string first, string second, string meant)
    {
        var call = CliCall.Of(second.Length > 0 ? new[] { first, second } : new[] { first });
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.Contain("did you mean " + meant + "?"));
    }

    [TestCase("convert a.las --out b", "--output")]
    [TestCase("picture a.las -o p.png --top", "--view")]
    [TestCase("picture a.las -o p.png --class 2", "--style classes=N")]
    [TestCase("export a.las -o b.las --class 2", "--classes")]
    [TestCase("preview a.las -o p.png --colour=red", "--style color=NAME")]
    [TestCase("export a.las -o b.las --bbox 3", "--clip")]
    [TestCase("preview a.las -o p.png --budget 3", "--points")]
    [TestCase("convert a.las -o q.fastpoints --mem 1GiB", "--memory")]
    [TestCase("verify a.fastpoints --agianst a.las", "--against")]
    [TestCase("a.las --budget 3", null)]
    [TestCase("a.las --view top", null)]
    [TestCase("info a.las --size", null)]
    [TestCase("fly a.las --fps 3", null)]
    [TestCase("picture a.las -o p.png --exact", null)]
    public void Option_OfAnotherVerbOrProgram_SuggestsTheEquivalent(string line, string meant)
    {
        var call = CliCall.Of(line.Split(' '));
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.StartWith("fastpoints: unknown option --"));
        Assert.That(call.Error, meant == null ? Does.Not.Contains("did you mean") : Does.Contain("did you mean " + meant + "?"));
    }

    [Test]
    public void Option_OfTheMainJobAfterAnotherVerb_IsNotSuggested()
    {
        var call = CliCall.Of("info", "x.las", "--points", "5");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.Contain("unknown option --points").And.Not.Contains("mean --points?"));
    }

    [Test]
    public void HelpAndVersion_AsVerbs_AreUnderstood()
    {
        Assert.That(CliCall.Of("help").Output, Is.EqualTo(CliCall.Of("--help").Output));
        Assert.That(CliCall.Of("help", "convert").Output, Is.EqualTo(CliCall.Of("convert", "--help").Output));
        Assert.That(CliCall.Of("version").Output, Is.EqualTo(CliCall.Of("--version").Output));
    }

    [TestCase("info", "--no-such-option", "x.las")]
    [TestCase("info")]
    [TestCase("preview", "x.las")]
    [TestCase("demo-cloud")]
    [TestCase("demo-cloud", "-o", "x.las", "--points", "many")]
    [TestCase("--no-such-option")]
    [TestCase("x.las", "info", "y.las")]
    [TestCase("--points", "5", "info", "x.las")]
    [TestCase("--as-one", "info", "x.las")]
    [TestCase("preview", "x.las", "-o", "x.png", "--points", "1.5")]
    [TestCase("preview", "x.las", "-o", "x.png", "--points", "-2M")]
    [TestCase("bench", "--runs", "0")]
    [TestCase("fly", "x.fastpoints", "--frames", "0")]
    [TestCase("picture", "x.las", "-o", "x.png", "--budget", "0")]
    public void Arguments_ThatDoNotParse_AreUsageErrorsWithTheUsage(params string[] args)
    {
        var call = CliCall.Of(args);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.StartWith("fastpoints: "));
        Assert.That(call.Error, Does.Contain("\nusage: ./fastpoints"));
        Assert.That(call.Output, Is.Empty);
    }

    [TestCase("info", "x.las", "--threads", "0")]
    [TestCase("preview", "x.las", "-o", "x.png", "--points", "0")]
    [TestCase("picture", "x.las", "-o", "x.png", "--samples", "5")]
    [TestCase("picture", "x.las", "-o", "x.png", "--samples", "2", "--gpu")]
    [TestCase("picture", "x.las", "-o", "x.png", "--size", "big")]
    [TestCase("picture", "x.las", "-o", "x.png", "--size", "1x99999999")]
    [TestCase("picture", "x.las", "-o", "x.png", "--eye", "1,2,3")]
    [TestCase("picture", "x.las", "-o", "x.png", "--eye", "1,2,3", "--target", "1,2")]
    [TestCase("picture", "x.las", "-o", "x.png", "--view", "sideways")]
    [TestCase("picture", "x.las", "-o", "x.png", "--view", "top", "--eye", "1,2,3", "--target", "0,0,0")]
    [TestCase("picture", "x.las", "-o", "x.png", "--fov", "180")]
    [TestCase("picture", "x.las", "-o", "x.png", "--style", "color=")]
    [TestCase("picture", "x.las", "-o", "x.png", "--style", "shiny")]
    [TestCase("demo-cloud", "-o", "x.las", "--points", "0")]
    [TestCase("demo-cloud", "-o", "x.xyz")]
    [TestCase("demo-cloud", "-o", "x.las", "--order", "spiral")]
    [TestCase("demo-cloud", "-o", "x.las", "--order", "random", "--points", "99999999999")]
    [TestCase("demo-cloud", "-o", "x.las", "--times", "3")]
    [TestCase("demo-cloud", "-o", "x.las", "--tile", "y.las")]
    [TestCase("bench", "no such workload")]
    [TestCase("preview", "x.las", "-o", "x.jpg")]
    [TestCase("picture", "x.las", "-o", "x.tiff")]
    [TestCase("info", "x.las", "--json", "x.png")]
    [TestCase("convert", "x.las", "-o", "x.png")]
    [TestCase("fly", "x.fastpoints", "-o", "x.jpg")]
    [TestCase("preview", "x.las", "-o", "x.png", "--report-output", "x")]
    public void Arguments_Contradictory_AreUsageErrors(params string[] args)
    {
        var call = CliCall.Of(args);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage), call.Error);
        Assert.That(call.Error, Does.Contain("\nusage: ./fastpoints " + args[0]));
    }
}
