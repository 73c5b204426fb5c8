using FastPoints.HostTests.Shaders;

namespace FastPoints.PageTests;

/// <summary>COPC files as browsers read them: by copc.js, whose decoder is LASzip's.</summary>
public sealed class CopcJsTests
{
    [Test]
    public void Export_OfADemo_EveryNodeAndPointIsReadByCopcJs()
    {
        string packages = Path.GetFullPath(Path.Combine(AppContext.BaseDirectory, "../../../copcjs"));
        if (Tool.Find("node") is not { } node || !Directory.Exists(Path.Combine(packages, "node_modules", "copc")))
        {
            Assert.Ignore("no node, or none of the packages of Headless/CopcJs");
            return;
        }
        using var scratch = new ScratchFolder();
        string demo = scratch.Demo(points: 400_000), copc = scratch["demo.copc.laz"];
        Assert.That(CliCall.Of("export", demo, "-o", copc, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
        var source = CliCall.Of("info", "--scan", demo, "--json", "-", "--quiet").Json.GetProperty("columnSums");
        var (isGood, said) = Tool.Run(node, Path.Combine(packages, "check.mjs"), copc);
        Assert.That(isGood, said);
        using var json = JsonDocument.Parse(said);
        var read = json.RootElement;
        long Number(string name) => read.GetProperty(name).GetInt64();
        Assert.That((Number("points"), Number("pointsOfNodes"), Number("pointFormat"), Number("outside")),
            Is.EqualTo((400_000L, 400_000L, 7L, 0L)));
        Assert.That(Number("nodes"), Is.GreaterThan(20));
        Assert.That(read.GetProperty("hasWkt").GetBoolean());
        foreach (string name in new[] { "X", "Y", "Z", "Intensity", "ReturnNumber", "Classification", "PointSourceId", "Red" })
            Assert.That(read.GetProperty("sums").GetProperty(name).GetDouble(),
                Is.EqualTo((double)long.Parse(source.GetProperty(name).GetString()!)), name);
    }
}
