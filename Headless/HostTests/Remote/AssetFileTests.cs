namespace FastPoints.HostTests.Remote;

/// <summary>Streaming assets of an Android player, which AsyncReadManager alone reads, by address.</summary>
[NonParallelizable]
sealed class AssetFileTests : RemoteFixture
{
    string m_assets;

    [SetUp]
    public void Pack()
    {
        AssetFile.Register();
        m_assets = "jar:file://" + Scratch["base.apk!/assets"];
        Directory.CreateDirectory(Scratch["base.apk!/assets"]);
    }

    [Test]
    public void Read_OfAnAsset_IsItsBytes()
    {
        byte[] bytes = new byte[3_000_000];
        new System.Random(1).NextBytes(bytes);
        File.WriteAllBytes(Scratch["base.apk!/assets/a b#1.bin"], bytes);
        string address = SourcePath.Combine(m_assets, "a b#1.bin");
        Assert.That(File.Exists(address), Is.False, "as in Unity");

        RemoteFile file = RemoteFile.Open(address);

        Assert.That(Read(file, 0, bytes.Length).AsSpan().SequenceEqual(bytes));
        Assert.That(Read(file, 2_999_990, 10), Is.EqualTo(bytes[^10..]));
        Assert.That(SourcePath.NameOf(address), Is.EqualTo("a b#1.bin"));
        Assert.That(SourcePath.FolderOf(address), Is.EqualTo(m_assets));
        Assert.That(((PointCloudException)Try(() => Read(file, 2_999_990, 11))).Code, Is.EqualTo(FailureCode.Truncated));
        AssertOneLine(Try(() => RemoteFile.Open(m_assets + "/no.bin")), m_assets + "/no.bin");
    }

    [TestCase("scan.fastpoints")]
    [TestCase("scan.copc.laz")]
    [TestCase("scan.las")]
    public void Cloud_OfAnAsset_HasThePointsOfTheDisk(string name)
    {
        string las = Scratch.Demo("scan.las", 60_000), path = Scratch["base.apk!/assets/" + name];
        string[] make = name == "scan.fastpoints" ? ["convert", las, "-o", path] : ["export", las, "-o", path];
        if (name == "scan.las")
            File.Copy(las, path);
        else
            Assert.That(CliCall.Of([.. make, "--quiet"]).Status, Is.Zero);
        byte[] Picture(string from)
        {
            var call = CliCall.Of("picture", from, "-o", Scratch["a.png"], "--size", "160x120", "--force", "--plain", "--quiet");
            Assert.That(call.Status, Is.Zero, call.Error);
            return File.ReadAllBytes(Scratch["a.png"]);
        }
        byte[] wanted = Picture(path);
        RemoteStatistics.Reset();

        Assert.That(Picture(SourcePath.Combine(m_assets, name)), Is.EqualTo(wanted));

        Assert.That((RemoteStatistics.Requests, RemoteStatistics.Waits), Is.EqualTo((0L, 0L)));
        Assert.That(RemoteStatistics.BytesFetched, Is.Positive);
    }
}
