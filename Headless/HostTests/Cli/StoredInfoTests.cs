namespace FastPoints.HostTests.Cli;

public sealed class StoredInfoTests : ScratchTests
{
    string m_demo, m_cloud;

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_demo = Scratch.Demo(points: 20_000);
        m_cloud = Scratch["cloud.fastpoints"];
        Assert.That(CliCall.Of("convert", m_demo, "-o", m_cloud).Status, Is.Zero);
    }

    [Test]
    public void Info_OfAConvertedCloud_MatchesItsSource()
    {
        var cloud = CliCall.Of("info", m_cloud, "--json", "-").Json;
        var source = CliCall.Of("info", "--scan", m_demo, "--json", "-").Json;
        var verified = CliCall.Of("verify", m_cloud, "--json", "-").Json;
        Assert.That(cloud.GetProperty("format").GetString(), Is.EqualTo("FastPoints"));
        Assert.That(cloud.GetProperty("isWhole").GetBoolean(), Is.True);
        Assert.That(cloud.GetProperty("pointsAre").GetString(), Is.EqualTo("counted"));
        Assert.That(cloud.GetProperty("pointsFound").GetInt64(), Is.EqualTo(20_000));
        foreach (string key in new[] { "points", "bounds", "crs", "crsEpsg", "crsWkt", "crsMetresPerUnit" })
            Assert.That(cloud.GetProperty(key).GetRawText(), Is.EqualTo(source.GetProperty(key).GetRawText()), key);
        Assert.That(cloud.GetProperty("crsEpsg").GetInt32(), Is.EqualTo(32632));

        var ranges = source.GetProperty("attributes").EnumerateArray().ToDictionary(a => a.GetProperty("name").GetString());
        foreach (var attribute in cloud.GetProperty("attributes").EnumerateArray())
            foreach (string end in new[] { "min", "max" })
                Assert.That(attribute.GetProperty(end).GetDouble(),
                    Is.EqualTo(ranges[attribute.GetProperty("name").GetString()].GetProperty(end).GetDouble()));
        var levels = cloud.GetProperty("tree").GetProperty("levels").EnumerateArray().ToArray();
        Assert.That(levels.Sum(l => l.GetProperty("points").GetInt64()), Is.EqualTo(20_000));
        foreach (var level in verified.GetProperty("levels").EnumerateArray())
            foreach (string key in new[] { "nodes", "points", "spacing" })
                Assert.That(levels[level.GetProperty("level").GetInt32()].GetProperty(key).GetRawText(),
                    Is.EqualTo(level.GetProperty(key).GetRawText()), key);
        Assert.That(cloud.GetProperty("bytesOnDisk").GetInt64(),
            Is.EqualTo(Directory.GetFiles(m_cloud, "*", SearchOption.AllDirectories).Sum(f => new FileInfo(f).Length)));
        var planes = cloud.GetProperty("bytesOfPlane").EnumerateObject().ToArray();
        Assert.That(planes.Select(p => p.Name), Does.Contain("position").And.Contain("color"));
        Assert.That(planes.Sum(p => p.Value.GetInt64()), Is.InRange(1, cloud.GetProperty("bytesOnDisk").GetInt64()));
        Assert.That(cloud.GetProperty("sources")[0].GetProperty("name").GetString(), Is.EqualTo(Path.GetFileName(m_demo)));
        Assert.That(cloud.GetProperty("sampler").GetString(), Is.EqualTo("poisson"));
    }

    [Test]
    public void Info_OfCloudAndFiles_ListsAll()
    {
        var call = CliCall.Of("info", m_demo, m_cloud);
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Output, Does.Contain("converted cloud").And.Contain("LAS 1.4"));
        Assert.That(call.Output, Does.Match(@"unit +metres"));
    }

    [Test]
    public void Info_OfADamagedCloud_IsBadInput()
    {
        string broken = Scratch["broken.fastpoints"];
        Directory.CreateDirectory(broken);
        File.Copy(Path.Combine(m_cloud, "cloud.json"), Path.Combine(broken, "cloud.json"));
        Assert.That(CliCall.Of("info", broken).Status, Is.EqualTo(ExitStatus.BadInput));
    }

    [Test]
    public void Json_HasTheFactsOfTheText()
    {
        var call = CliCall.Of("info", m_demo, "--json", Scratch["facts.json"]);
        var facts = JsonDocument.Parse(File.ReadAllBytes(Scratch["facts.json"])).RootElement.GetProperty("facts");
        Assert.That(facts.GetArrayLength(), Is.GreaterThan(3));
        foreach (var fact in facts.EnumerateArray())
            Assert.That(call.Output, Does.Contain(fact.GetProperty("name").GetString())
                .And.Contain(fact.GetProperty("value").GetString()));
    }

    /// <summary>Against the bytes of the records themselves: LAS 1.4, point format 7.</summary>
    [Test]
    public void Scan_OfAFile_CountsClassesAndReturns()
    {
        byte[] las = File.ReadAllBytes(m_demo);
        int first = BitConverter.ToInt32(las, 96), record = BitConverter.ToUInt16(las, 105);
        var records = Enumerable.Range(0, 20_000).Select(i => first + i * record).ToArray();
        foreach (string threads in new[] { "1", "2" })
        {
            var call = CliCall.Of("info", "--scan", m_demo, "--json", Scratch["scan.json"], "--threads", threads);
            var json = JsonDocument.Parse(File.ReadAllBytes(Scratch["scan.json"])).RootElement;
            HasCounts(json.GetProperty("classes"), records.Select(at => (int)las[at + 16]));
            HasCounts(json.GetProperty("returns"), records.Select(at => las[at + 14] & 15));
            Assert.That(call.Output, Does.Match(@"class +points").And.Match(@"return +points"));
        }
        var unscanned = CliCall.Of("info", m_demo, "--json", "-").Json;
        Assert.That(unscanned.TryGetProperty("classes", out _), Is.False, "nothing was counted");
    }

    [Test]
    public void Scan_OfAFile_GivesRobustBoundsAndDensity()
    {
        byte[] las = File.ReadAllBytes(m_demo);
        int first = BitConverter.ToInt32(las, 96), record = BitConverter.ToUInt16(las, 105);
        var records = Enumerable.Range(0, 20_000).Select(i => first + i * record).ToArray();
        var call = CliCall.Of("info", "--scan", m_demo, "--json", Scratch["spread.json"]);
        var json = JsonDocument.Parse(File.ReadAllBytes(Scratch["spread.json"])).RootElement;
        var box = json.GetProperty("boundsNearlyAll");
        for (int axis = 0; axis < 3; axis++)
        {
            double scale = BitConverter.ToDouble(las, 131 + 8 * axis), offset = BitConverter.ToDouble(las, 155 + 8 * axis);
            double[] sorted = [.. records.Select(at => BitConverter.ToInt32(las, at + 4 * axis) * scale + offset).Order()];
            Assert.That(box.GetProperty("min")[axis].GetDouble(), Is.EqualTo(sorted[10]).Within(1e-6));
            Assert.That(box.GetProperty("max")[axis].GetDouble(), Is.EqualTo(sorted[^11]).Within(1e-6));
        }
        double[] times = [.. records.Select(at => BitConverter.ToDouble(las, at + 22))];
        Assert.That(json.GetProperty("gpsTimeSpan").GetDouble(), Is.EqualTo(times.Max() - times.Min()).Within(1e-9));
        var density = json.GetProperty("density");
        double Of(string key) => density.GetProperty(key).GetDouble();
        Assert.That(density.GetProperty("unit").GetString(), Is.EqualTo("points/m²"));
        Assert.That(Of("lowerQuartile"), Is.GreaterThan(0).And.LessThanOrEqualTo(Of("median")));
        Assert.That(Of("median"), Is.LessThanOrEqualTo(Of("upperQuartile")));
        // Each is the count of a square.
        double count = Of("median") * Of("squareEdge") * Of("squareEdge");
        Assert.That(count, Is.EqualTo(Math.Round(count)).Within(1e-6).And.GreaterThan(0));
        Assert.That(call.Output, Does.Match("99.9 % lie in +x").And.Match("density +median").And.Match("GPS time span +"));
        foreach (string key in new[] { "bytes", "recordBytes", "pointsNotFinite" })
            Assert.That(json.GetProperty(key).ValueKind, Is.EqualTo(JsonValueKind.Number), key);
    }

    [Test]
    public void MainJob_OfAConvertedCloud_ReportsOnIt()
    {
        var call = CliCall.Of(m_cloud, "-o", Scratch["stored"], "--json", Scratch["stored.json"]);
        Assert.That(call.Status, Is.Zero, call.Error);
        var info = JsonDocument.Parse(File.ReadAllBytes(Scratch["stored.json"])).RootElement.GetProperty("info");
        Assert.That(info.GetProperty("points").GetInt64(), Is.EqualTo(20_000));
        Assert.That(info.GetProperty("isWhole").GetBoolean(), Is.True);
        string page = File.ReadAllText(Scratch["stored/report.html"]);
        foreach (string text in new[] { "20,000", "32632", "spacing", "Classification", "bytes a point",
            "poisson", "demo.las", "yes" })
            Assert.That(page, Does.Contain(text));
        Assert.That(Png.Read(Scratch["stored/picture.png"]).Rgba.Distinct().Count(), Is.GreaterThan(10));
        Assert.That(CliCall.Of(m_cloud, "-o", Scratch["stored"]).Status, Is.Zero, "the same report again");
        Assert.That(CliCall.Of(m_demo, "-o", Scratch["stored"]).Status, Is.EqualTo(ExitStatus.Usage), "another's");
    }

    [Test]
    public void Manual_ForMan_HasEachVerbAndOption()
    {
        var call = CliCall.Of("help", "--man");
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Output, Does.StartWith(".TH FASTPOINTS 1\n").And.Contain(".SH EXPORT\n").And.Contain("\\-\\-sampler"));
        Assert.That(call.Output.Split('\n').Where(l => l.StartsWith('.')).Select(l => l.Split(' ')[0]).Distinct(),
            Is.SubsetOf(new[] { ".TH", ".SH", ".TP", ".br", ".PP" }));
        string plain = call.Output.Replace("\\-", "").Replace("\\e", "").Replace("\\&", "");
        Assert.That(plain, Does.Not.Contain('\\').And.Not.Contain('-'));
    }

    static void HasCounts(JsonElement json, IEnumerable<int> values)
    {
        var wanted = values.GroupBy(v => v).ToDictionary(g => g.Key.ToString(), g => g.LongCount());
        Assert.That(wanted, Has.Count.GreaterThan(1), "something to tell apart");
        Assert.That(json.EnumerateObject().ToDictionary(p => p.Name, p => p.Value.GetInt64()), Is.EquivalentTo(wanted));
    }

    [Test]
    public void MainJob_OfCopc_CountsItsNodes()
    {
        string copc = TestData.SampleOrIgnore("copc/example.copc.laz");
        var tree = CliCall.Of(copc, "-o", Scratch["copc"], "--json", "-").Json.GetProperty("info").GetProperty("tree");
        Assert.That(tree.GetProperty("nodes").GetInt32(), Is.GreaterThan(0));
        Assert.That(tree.GetProperty("isWhole").GetBoolean(), Is.True);
    }

    [TestCase("[suggest:3]", "inf", "info")]
    [TestCase("[suggest:9]", "info --sc", "--scan")]
    [TestCase("[suggest:3]", "con", "convert")]
    public void Suggest_Prefix_ListsCompletions(string directive, string line, string word)
    {
        var call = CliCall.Of(directive, line);
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Output.Split('\n').Select(l => l.Trim()), Does.Contain(word));
    }

    [Test]
    public void Completion_InBash_CompletesVerbsAndOptions()
    {
        if (!OperatingSystem.IsLinux())
            Assert.Ignore("no bash");
        string script = CliCall.Of("completion", "bash").Output;
        File.WriteAllText(Scratch["ask.sh"], script + """
            COMP_LINE="$1" COMP_POINT=${#1} COMP_WORDS=($1) COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
            _fastpoints
            printf '%s\n' "${COMPREPLY[@]}"
            """);
        string program = Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli");
        foreach (var (line, wanted) in new[] { ("conv", "convert"), ("info --sc", "--scan"), ("picture --bud", "--budget") })
        {
            using var bash = System.Diagnostics.Process.Start(new System.Diagnostics.ProcessStartInfo("bash",
                [Scratch["ask.sh"], program + " " + line])
            { RedirectStandardOutput = true });
            Assert.That(bash.StandardOutput.ReadToEnd().Trim(), Is.EqualTo(wanted), line);
            bash.WaitForExit();
        }
    }

    [Test]
    public void Completion_OfEachShell_IsAScriptThatAsks()
    {
        foreach (string shell in new[] { "bash", "zsh", "fish", "powershell" })
            Assert.That(CliCall.Of("completion", shell).Output, Does.Contain("[suggest:").And.Contain("fastpoints"));
        Assert.That(CliCall.Of("completion", "tcsh").Status, Is.EqualTo(ExitStatus.Usage));
    }
}
