namespace FastPoints.HostTests.Cli;

public sealed class ZstandardTests
{
    [Test]
    public void Info_ZstandardOctree_HasTheSumsOfItsTwin()
    {
        string folder = Path.GetDirectoryName(TestData.SampleOrIgnore("ept/ellipsoid-zstandard/ept.json"));
        JsonElement got = Scan(folder), wanted = Scan(TestData.SampleOrIgnore("copc/ellipsoid.copc.laz"));
        Assert.That(got.GetProperty("points").GetInt64(), Is.EqualTo(100000));
        foreach (string name in new[] { "X", "Y", "Z", "Intensity", "Classification", "GpsTime", "Red", "Green", "Blue" })
            Assert.That(Sum(got, name), Is.EqualTo(Sum(wanted, name)), name);
    }

    private static string Sum(JsonElement summary, string name) =>
        summary.GetProperty("columnSums").GetProperty(name).GetString();

    private static JsonElement Scan(string path)
    {
        var call = CliCall.Of("info", "--scan", path, "--json", "-");
        if (call.Error.Contains("Decompressors.Zstandard", StringComparison.Ordinal))
            Assert.Ignore("libzstd is not installed");
        Assert.That(call.Status, Is.EqualTo(0), call.Error);
        return call.Json;
    }
}
