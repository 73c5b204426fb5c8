namespace FastPoints.HostTests.Editor;

public sealed class CloudHandleTests
{
    [Test]
    public void Handle_WrittenAndRead_RoundTrips()
    {
        using var scratch = new ScratchFolder();
        string source = scratch.Demo();
        var handle = new CloudHandle
        {
            CloudId = 0xFEDCBA9876543210UL,
            CloudPath = "PointClouds/scan.fastpoints",
            Stamp = SourceStamp.Of(new[] { source }),
            Sources = { source, "Assets/\"odd\".las" },
        };
        using (var reader = PointReaders.Open(source))
            handle.SetFrom(reader.Info);
        Assert.That(handle.Points, Is.EqualTo(3000));
        Assert.That(handle.BoundsGeo.IsEmpty, Is.False);

        var read = CloudHandle.FromJson(handle.ToJson(), "scan.pointcloud");

        Assert.That(read.ToJson(), Is.EqualTo(handle.ToJson()));
        Assert.That(read.CloudId, Is.EqualTo(handle.CloudId));
        Assert.That(read.Sources, Is.EqualTo(handle.Sources));
        Assert.That(math.all(read.BoundsGeo.Max == handle.BoundsGeo.Max), Is.True);
        Assert.That(read.Stamp.Compare(new[] { source }), Is.EqualTo(SourceChange.None));
    }

    [TestCase(2, 2, "b.las: at byte 7: odd 1")]
    [TestCase(30, CloudHandle.MaxWarnings, "11 more")]
    public void Describe_Warnings_AreKeptUpToALimit(int count, int kept, string last)
    {
        var handle = new CloudHandle { CloudPath = "a" };

        handle.SetFrom("LAS", Enumerable.Range(0, count).Select(i => new CloudWarning("/home/a/b.las", 7, "odd " + i)).ToList());

        var read = CloudHandle.FromJson(handle.ToJson(), "a.pointcloud");
        Assert.That(read.Warnings, Has.Count.EqualTo(kept).And.Some.EqualTo("b.las: at byte 7: odd 0"));
        Assert.That(read.Warnings.Last(), Is.EqualTo(last));
        Assert.That(read.Format, Is.EqualTo("LAS"));
    }

    [Test]
    public void Handle_WithoutFacts_RoundTrips()
    {
        var handle = new CloudHandle { CloudPath = "a", Units = new CloudUnits(double.NaN, 0.3048) };

        var read = CloudHandle.FromJson(handle.ToJson(), "a.pointcloud");

        Assert.That(read.BoundsGeo.IsEmpty, Is.True);
        Assert.That(read.Stamp, Is.Null);
        Assert.That(read.Points, Is.EqualTo(-1));
        Assert.That(read.Units.IsInDegrees);
        Assert.That(read.Units.Vertical, Is.EqualTo(0.3048));
    }

    [TestCase("", FailureCode.BadInput, "at character 0")]
    [TestCase("[]", FailureCode.BadInput, "wanted an object")]
    [TestCase("{}", FailureCode.BadInput, "\"format\": missing")]
    [TestCase("{\"format\": \"other\"}", FailureCode.BadInput, "got \"other\"")]
    [TestCase("{\"format\": \"fastpoints-handle\", \"version\": 2}", FailureCode.Unsupported, "wanted 1, got 2")]
    [TestCase("{\"format\": \"fastpoints-handle\", \"version\": 1, \"cloudId\": \"12\"}", FailureCode.BadInput, "\"cloudId\"")]
    public void FromJson_OtherJson_NamesFileAndMember(string text, FailureCode code, string reported) =>
        Assert.That(() => CloudHandle.FromJson(text, "x.pointcloud"), Throws.TypeOf<PointCloudException>()
            .With.Property("Code").EqualTo(code).And.Message.StartsWith("x.pointcloud: ").And.Message.Contains(reported));

    [TestCase("\"points\": -1", "\"points\": \"many\"", "\"points\"")]
    [TestCase("\"cloud\": \"a\"", "\"cloud\": \"\"", "\"cloud\"")]
    [TestCase("\"sources\": [", "\"sources\": [1", "\"sources\"")]
    [TestCase("\"points\": -1", "\"points\": -1, \"bounds\": {\"min\": [0, 0], \"max\": [1, 1, 1]}", "\"min\"")]
    public void FromJson_PlantedMistake_NamesTheMember(string whole, string planted, string reported)
    {
        string text = new CloudHandle { CloudPath = "a" }.ToJson();
        Assert.That(text, Does.Contain(whole));

        Assert.That(() => CloudHandle.FromJson(text.Replace(whole, planted), "x"),
            Throws.TypeOf<PointCloudException>().With.Message.Contains(reported));
    }

    [Test]
    public void Paths_InTheProject_AreRelativeAndMoveWithIt()
    {
        using var scratch = new ScratchFolder();
        var paths = new ProjectPaths(scratch["one"]);
        string inside = Path.Combine(scratch["one"], "PointClouds", "a.fastpoints");

        Assert.That(paths.Stored(inside), Is.EqualTo("PointClouds/a.fastpoints"));
        Assert.That(paths.Stored("Assets/b.las"), Is.EqualTo("Assets/b.las"));
        Assert.That(new ProjectPaths(scratch["two"]).Absolute("PointClouds/a.fastpoints"),
            Is.EqualTo(Path.Combine(scratch["two"], "PointClouds", "a.fastpoints")));
        Assert.That(paths.Absolute(paths.Stored(scratch["beside.las"])), Is.EqualTo(scratch["beside.las"]));
        Assert.That(paths.Stored(scratch["onemore.las"]), Is.EqualTo("../onemore.las"),
            "a folder's name that begins like the project's is not in it");
    }
}
