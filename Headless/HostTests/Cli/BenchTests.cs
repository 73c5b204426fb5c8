namespace FastPoints.HostTests.Cli;

/// <summary>A run of workloads: its results as Unity's package would write them, its page, and runs beside earlier
/// ones.</summary>
public sealed class BenchTests : ScratchTests
{
    string m_results;

    [OneTimeSetUp]
    public void RunTwoWorkloads()
    {
        Bench("first");
        m_results = Path.Combine(Scratch["first"], PerformanceResults.FileName);
    }

    CliCall Bench(string folder, params string[] more) => Bench(folder, "2000", more);

    CliCall Bench(string folder, string points, string[] more)
    {
        string[] typical = ["bench", "loop over", "--runs", "4", "--points", points, "--out", Scratch[folder]];
        var call = CliCall.Of([.. typical, .. more]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        return call;
    }

    [Test]
    public void Results_OfARun_HaveEverySampleAndItsFigures()
    {
        using var json = JsonDocument.Parse(File.ReadAllBytes(m_results));
        var result = json.RootElement.GetProperty("Results").EnumerateArray()
            .Single(r => r.GetProperty("Name").GetString()!.EndsWith("(\"loop over native arrays\")"));
        var groups = result.GetProperty("SampleGroups").EnumerateArray().ToDictionary(g => g.GetProperty("Name").GetString()!);

        Assert.That(groups.Keys, Is.EquivalentTo(new[] { "Time", "Points/s", "Bytes/s", "GC", "Error", "Times limit" }));
        Assert.That(groups["Time"].GetProperty("Unit").GetInt32(), Is.EqualTo(2));
        Assert.That(groups["GC"].GetProperty("Unit").GetInt32(), Is.EqualTo(4));
        Assert.That(groups["Points/s"].GetProperty("IncreaseIsBetter").GetBoolean(), Is.True);
        foreach (var group in groups.Values)
        {
            double[] samples = group.GetProperty("Samples").EnumerateArray().Select(s => s.GetDouble()).ToArray();
            Assert.That(samples.Length, Is.EqualTo(4));
            Assert.That(group.GetProperty("Min").GetDouble(), Is.EqualTo(samples.Min()));
            Assert.That(group.GetProperty("Max").GetDouble(), Is.EqualTo(samples.Max()));
            Assert.That(group.GetProperty("Sum").GetDouble(), Is.EqualTo(samples.Sum()).Within(1e-9).Percent);
            Assert.That(group.GetProperty("Average").GetDouble(), Is.EqualTo(samples.Average()).Within(1e-9).Percent);
            Assert.That(group.GetProperty("Median").GetDouble(), Is.InRange(samples.Min(), samples.Max()));
            Assert.That(group.GetProperty("StandardDeviation").GetDouble(), Is.LessThanOrEqualTo(samples.Max() - samples.Min()));
        }
    }

    /// <summary>Field by field, so that whatever reads the package's files reads ours.</summary>
    [TestCase(typeof(PerformanceRun), "Run")]
    [TestCase(typeof(PerformanceTestResult), "PerformanceTestResult")]
    [TestCase(typeof(SampleGroup), "SampleGroup")]
    [TestCase(typeof(RunPlayer), "Player")]
    [TestCase(typeof(RunHardware), "Hardware")]
    [TestCase(typeof(RunEditor), "Editor")]
    public void Results_Classes_HaveTheFieldsOfThePackage(System.Type type, string name)
    {
        if (!Directory.Exists(Checkout.Repository.FullApi))
            Assert.Ignore($"no list of Unity's signatures in {Checkout.Repository.FullApi}");
        string prefix = "F:Unity.PerformanceTesting.Data." + name + ".";
        var wanted = UnityApi.LoadFull(Checkout.Repository.FullApi).Rows.Select(r => r.Id).Where(id => id.StartsWith(prefix))
            .Select(id => id[prefix.Length..]);

        Assert.That(type.GetFields(BindingFlags.Public | BindingFlags.Instance).Select(f => f.Name), Is.EquivalentTo(wanted));
    }

    [Test]
    public void Errors_OfWorkloadsWithANumber_AreACurve()
    {
        Assert.That(CliCall.Of("bench", "neighbours", "--runs", "1", "--points", "2000", "--out", Scratch["curve"]).Status,
            Is.EqualTo(ExitStatus.Done));
        string svg = File.ReadAllText(Path.Combine(Scratch["curve"], "errors.svg"));
        Assert.That(svg, Does.Contain("normals, N neighbours").And.Contain("degrees"));
        Assert.That(File.Exists(Path.Combine(Scratch["first"], "errors.svg")), Is.False);
    }

    [Test]
    public void Page_OfARun_HasAChartAndTheErrorBesideTheTime()
    {
        string html = File.ReadAllText(Path.Combine(Scratch["first"], "report.html"));
        int from = html.IndexOf("<svg", System.StringComparison.Ordinal);
        var svg = XElement.Parse(html[from..(html.IndexOf("</svg>", from, System.StringComparison.Ordinal) + 6)]);
        var texts = svg.Descendants().Where(e => e.Name.LocalName == "text").Select(e => e.Value).ToList();

        Assert.That(texts, Does.Contain("loop over native arrays").And.Contain("loop over pointers").And.Contain(
            "error").And.Contain("exact"));
        Assert.That(svg.Descendants().Count(e => ((string)e.Attribute("class"))?.Contains("mark") == true),
            Is.EqualTo(8), "each sample");
    }

    [Test]
    public void Baseline_SameInput_IsComparedBySamples()
    {
        var call = Bench("second", "--baseline", m_results);

        Assert.That(call.Output,
            Does.Contain("x baseline (95 %)").And.Match(@"\d\.\d\d \(\d\.\d\d to \d+\.\d\d\)").And.Contain("by chance"));
        Assert.That(File.ReadAllText(Path.Combine(Scratch["second"], "report.html")), Does.Contain("Against the earlier run"));
    }

    static BaselineRow[] Compare(double ownNow, double othersNow)
    {
        static WorkloadSamples Samples(string name, double ms)
        {
            var samples = new WorkloadSamples(name, null);
            for (int i = 0; i < 7; i++)
                samples.Add(ms * (1 + i / 100.0), 0, new WorkloadResult { Points = 1000 });
            return samples;
        }
        WorkloadSamples[] Run(double own, double others) =>
            [Samples("own", own), .. Enumerable.Range(0, 4).Select(i => Samples("other " + i, others))];
        var baseline = new Baseline("earlier.json", PerformanceResults.Of(Run(10, 10)));
        return baseline.Compare(Run(ownNow, othersNow)).ToArray();
    }

    [TestCase(20, 10, "slower")]
    [TestCase(5, 10, "faster")]
    [TestCase(10.1, 10, "within the noise")]
    [TestCase(20, 20, "slower, as all are")]
    [TestCase(15, 20, "slower, less than all are")]
    [TestCase(40, 20, "slower")]
    [TestCase(20, 5, "slower")]
    public void Baseline_ChangeBeyondTheCommonOne_IsNamed(double own, double others, string result) =>
        Assert.That(Compare(own, others)[0].Outcome, Is.EqualTo(result));

    [Test]
    public void Baseline_OtherInput_IsNotCompared() =>
        Assert.That(Bench("third", "3000", ["--baseline", m_results]).Output,
            Does.Contain("other input").And.Contain("No workload of that run"));

    [Test]
    public void Baseline_ASummary_HasMediansAndNoNoise()
    {
        string summary = Scratch["summary.json"];
        Bench("fourth", "--json", summary);

        Assert.That(Bench("fifth", "--baseline", summary).Output,
            Does.Contain("too few samples").And.Contain("nothing can be said of noise"));
    }

    [TestCase("{}")]
    [TestCase("{ \"workloads\": [ { \"name\": \"x\" } ] }")]
    [TestCase("no json")]
    public void Baseline_NoRunOfWorkloads_IsBadInput(string text)
    {
        string path = Scratch["bad.json"];
        File.WriteAllText(path, text);

        var call = CliCall.Of("bench", "loop over native arrays", "--runs", "1", "--points", "1000", "--out",
            Scratch["none"], "--baseline", path);

        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(call.Error, Does.Contain("bad.json").And.Contain("is neither a PerformanceTestResults.json nor"));
    }
}
