using FastPoints.Cli.Upgrade;

namespace FastPoints.HostTests.Upgrade;

/// <summary>Of a cloud that version 2 made of two files: three chunks, inlined leaves, colours, averages.</summary>
public sealed class UpgradeTests : ScratchPerTest
{
    const int PlaneCount = 6;

    static readonly string s_fixture = Path.Combine(Checkout.Repository.Root, "Headless/HostTests/Upgrade/Version2");
    static readonly string[] s_sources = [Path.Combine(s_fixture, "a.laz"), Path.Combine(s_fixture, "b.laz")];

    string m_cloud;

    [SetUp]
    public void CopyCloud()
    {
        m_cloud = Scratch["town.fastpoints"];
        foreach (string file in FilesOf(Path.Combine(s_fixture, "town.fastpoints")))
        {
            string copy = Path.Combine(m_cloud, Path.GetRelativePath(Path.Combine(s_fixture, "town.fastpoints"), file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy));
            File.Copy(file, copy);
        }
    }

    [Test]
    public void Upgrade_InPlace_KeepsPointsPlanesAndProvenance()
    {
        var planes = new List<ulong>();
        ulong id;
        using (var old = OldCloud.Open(m_cloud))
        {
            id = old.Manifest.CloudId;
            AddPlanes(old.Upper, PlaneCount, planes);
            foreach (var chunk in old.Chunks)
                using (var table = old.TableOf(chunk))
                    AddPlanes(table, PlaneCount, planes);
        }
        long before = BytesOf(m_cloud);
        byte[] records = File.ReadAllBytes(Path.Combine(m_cloud, "records.las"));
        var call = CliCall.Of("upgrade", m_cloud, "--json", "-");
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.EqualTo(400));
        Assert.That(call.Json.GetProperty("files").GetInt64(), Is.EqualTo(FilesOf(m_cloud).Length));
        Assert.That(call.Json.GetProperty("bytesBefore").GetInt64(), Is.EqualTo(before));
        Assert.That(call.Json.GetProperty("bytesAfter").GetInt64(), Is.EqualTo(BytesOf(m_cloud)));
        Assert.That(Directory.GetFileSystemEntries(Scratch.Root), Is.EqualTo(new[] { m_cloud }), "nothing is left beside it");

        AssertHasPoints(m_cloud);
        Assert.That(File.ReadAllBytes(Path.Combine(m_cloud, "records.las")), Is.EqualTo(records));
        var sources = CliCall.Of("info", m_cloud, "--json", "-").Json.GetProperty("sources");
        Assert.That(sources.EnumerateArray().Select(s => s.GetProperty("name").GetString() + s.GetProperty("points")),
            Is.EqualTo(new[] { "a.laz150", "b.laz250" }));
        using var folder = CloudFolder.Open(m_cloud);
        Assert.That(folder.Manifest.CloudId, Is.EqualTo(id));
        Assert.That(folder.EachTable().SelectMany(t => t.PlaneRanges.ToArray()).Where(p => p.LengthBytes > 0).Select(p => p.Hash)
            .Order(), Is.EqualTo(planes.Order()));
    }

    [Test]
    public void Upgrade_ToAnotherFolder_DrawsWhatAConversionDraws()
    {
        string made = Scratch["other.fastpoints"], anew = Scratch["anew.fastpoints"];
        var settings = new ConvertSettings
        {
            PointsPerChunk = 120,
            CellsLog2 = 4,
            TargetPointsPerLeaf = 40,
            Sampler = Nodes.Sampler.Average,
        };
        using (var reader = PointReaders.Open(s_sources))
            JobCoroutine.RunToEnd(ConvertCloud.Run([reader], anew, settings, _ => { }, null));
        var old = FilesOf(m_cloud).Select(File.ReadAllBytes).ToArray();
        Assert.That(CliCall.Of("upgrade", m_cloud, "-o", made).Status, Is.Zero);
        Assert.That(FilesOf(m_cloud).Select(File.ReadAllBytes), Is.EqualTo(old), "the old one stays");
        foreach (string cloud in new[] { made, anew })
            Assert.That(CliCall.Of("picture", cloud, "-o", cloud + ".png", "--size", "160x90").Status, Is.Zero);
        byte[] picture = Png.Read(made + ".png").Rgba;
        Assert.That(picture, Is.EqualTo(Png.Read(anew + ".png").Rgba));
        Assert.That(picture.Distinct().Count(), Is.GreaterThan(10), "the picture is empty");
        Assert.That(CliCall.Of("upgrade", m_cloud, "-o", made).Status, Is.EqualTo(ExitStatus.Usage), "there is one");
        Assert.That(CliCall.Of("upgrade", m_cloud, "-o", made, "--force").Status, Is.Zero);
    }

    [Test]
    public void Upgrade_OfPartsThatWereSampledApart_KeepsThemApart()
    {
        SampleApart(Path.Combine(m_cloud, "hierarchy.bin"));
        Assert.That(CliCall.Of("upgrade", m_cloud).Status, Is.Zero);
        AssertHasPoints(m_cloud);
        using var folder = CloudFolder.Open(m_cloud);
        var samplingGroups = folder.EachTable().SelectMany(t => t.Nodes.ToArray()).GroupBy(n => n.SamplingGroup)
            .ToDictionary(g => g.Key, g => g.Count());
        Assert.That(samplingGroups.Keys, Is.EquivalentTo(new[] { 0, 7 }));
        Assert.That(samplingGroups[7], Is.EqualTo(5));
    }

    [Test]
    public void Upgrade_Killed_LeavesOneOrTheOther()
    {
        var old = FilesOf(m_cloud).ToDictionary(f => f, File.ReadAllBytes);
        var random = new System.Random(1);
        int kept = 0;
        for (int i = 0; i < 6; i++)
        {
            using var process = Start();
            // The first at once when it has begun to write, the others a little later.
            while (!process.HasExited && !Directory.Exists(m_cloud + ".part"))
                Thread.Yield();
            for (var watch = Stopwatch.StartNew(); i > 0 && watch.Elapsed.TotalMilliseconds < 30 * random.NextDouble();)
                Thread.Yield();
            process.Kill();
            process.WaitForExit();
            if (!File.Exists(Path.Combine(m_cloud, "upper.bin")))
                break;
            kept++;
            foreach (var (file, bytes) in old)
                Assert.That(File.ReadAllBytes(file), Is.EqualTo(bytes), file);
        }
        Assert.That(kept, Is.Positive, "none was killed in time");
        Assert.That(CliCall.Of("upgrade", m_cloud).Status, Is.Zero);
        AssertHasPoints(m_cloud);
        Assert.That(Directory.Exists(m_cloud + ".part"), Is.False);
    }

    [TestCase("chunks/000002.bin", 100, "is damaged")]
    [TestCase("chunks/000003.bin", -20, "is damaged")]
    [TestCase("chunks/000004.bin", 40, "is damaged")]
    [TestCase("upper.bin", 300, "is damaged")]
    [TestCase("hierarchy.bin", 500, "is damaged")]
    public void Upgrade_OfADamagedCloud_SaysWhereInOneLine(string name, int at, string what)
    {
        string file = Path.Combine(m_cloud, name);
        byte[] bytes = File.ReadAllBytes(file);
        bytes[at < 0 ? bytes.Length + at : at] ^= 4;
        File.WriteAllBytes(file, bytes);
        AssertRefused(file + ": ", what);
        Assert.That(File.ReadAllBytes(file), Is.EqualTo(bytes), "it is as it was");
    }

    [Test]
    public void Upgrade_OfTablesWithMistakesOfAnySort_MakesACloudOrSaysOneLine()
    {
        string file = Path.Combine(m_cloud, "hierarchy.bin"), made = Scratch["made.fastpoints"];
        byte[] right = File.ReadAllBytes(file);
        var random = new System.Random(5);
        int refused = 0;
        for (int i = 0; i < 300; i++)
        {
            byte[] bytes = right.ToArray();
            for (int n = random.Next(1, 4); n > 0; n--)
                bytes[random.Next(80, bytes.Length)] = (byte)(random.Next(2) == 0 ? random.Next(256) : random.Next(3) - 1);
            WriteHierarchy(file, bytes);
            var call = CliCall.Of("upgrade", m_cloud, "-o", made, "--force", "--quiet");
            Assert.That(call.Status, Is.AnyOf(ExitStatus.Done, ExitStatus.BadInput), call.Error);
            refused += call.Status == ExitStatus.Done ? 0 : call.ErrorLines;
        }
        Assert.That(refused, Is.InRange(100, 300));
    }

    [Test]
    public void Upgrade_BesideAStoppedConversion_KeepsThat()
    {
        string journal = Path.Combine(m_cloud + ".part", "build.json");
        Directory.CreateDirectory(Path.GetDirectoryName(journal));
        File.WriteAllText(journal, "{}");
        var call = CliCall.Of("upgrade", m_cloud);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Failed));
        Assert.That(call.Error, Does.Contain(m_cloud + ".part: is a conversion that was stopped"));
        Assert.That(File.Exists(journal), Is.True);
    }

    [Test]
    public void Upgrade_WhatNeedsNone_SaysSo()
    {
        Assert.That(CliCall.Of("upgrade", m_cloud).Status, Is.Zero);
        var call = CliCall.Of("upgrade", m_cloud);
        Assert.That(call.Status, Is.Zero);
        Assert.That(call.Output, Does.StartWith(m_cloud + ": is of version 3 already"));
        AssertRefused(m_cloud, "is of version 3 already", "-o", Scratch["other.fastpoints"]);
        string none = Scratch["none.fastpoints"];
        Assert.That(CliCall.Of("upgrade", none).Error, Does.Contain(none + ": wanted a folder"));
    }

    [Test]
    public void Verbs_OfAVersion2Cloud_NameTheCommand()
    {
        foreach (string[] verb in new[]
        {
            new[] { "info", m_cloud }, ["verify", m_cloud], ["picture", m_cloud, "-o", Scratch["p.png"]], ["fly", m_cloud],
            ["export", m_cloud, "-o", Scratch["e.las"]], ["publish", m_cloud], [m_cloud, "-o", Scratch["report"]],
        })
        {
            var call = CliCall.Of([.. verb, "--quiet"]);
            Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput), verb[0]);
            Assert.That(call.Error + call.Output, Does.Contain("fastpoints upgrade " + m_cloud), verb[0]);
            Assert.That(call.ErrorLines, Is.EqualTo(1), verb[0]);
        }
        // What scenes and the editor open clouds by.
        Assert.That(() => CloudFolder.Open(m_cloud), Throws.TypeOf<PointCloudException>().With.Message
            .Contains("fastpoints upgrade " + m_cloud).And.Property(nameof(PointCloudException.Code))
            .EqualTo(FailureCode.Unsupported));
    }

    void AssertRefused(string where, string what, params string[] more)
    {
        var call = CliCall.Of(["upgrade", m_cloud, "--quiet", .. more]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput), call.Error);
        Assert.That(call.Error, Does.StartWith("fastpoints: " + where).And.Contain(what));
        Assert.That(call.ErrorLines, Is.EqualTo(1));
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetFileSystemEntries(Scratch.Root), Is.EqualTo(new[] { m_cloud }));
    }

    static void AssertHasPoints(string cloud)
    {
        var call = CliCall.Of(["verify", cloud, "--against", .. s_sources]);
        Assert.That(call.Status, Is.Zero, call.Output + call.Error);
        Assert.That(call.Output, Does.Contain("400 points, all there, the same as in the source"));
    }

    Process Start() => Process.Start(new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"),
        ["upgrade", m_cloud, "--quiet"])
    {
        RedirectStandardOutput = true,
    });

    /// <summary>Gives a node that has children, and all below it, a number of their own.</summary>
    static unsafe void SampleApart(string file)
    {
        byte[] bytes = File.ReadAllBytes(file);
        fixed (byte* first = bytes)
        {
            var header = (OldHeader*)first;
            var nodes = (NodeRecord*)(first + header->TableOffset);
            int top = 1;
            while (nodes[top].ChildCount == 0)
                top++;
            for (int i = top; i < header->NodeCount; i++)
                if (i == top || nodes[i].Parent >= 0 && nodes[nodes[i].Parent].SamplingGroup == 7)
                    nodes[i].SamplingGroup = 7;
        }
        WriteHierarchy(file, bytes);
    }

    static void WriteHierarchy(string file, byte[] bytes)
    {
        File.WriteAllBytes(file, bytes);
        string manifest = Path.Combine(Path.GetDirectoryName(file), "cloud.json");
        File.WriteAllText(manifest, Regex.Replace(File.ReadAllText(manifest), "\"hierarchyHash\": \"[0-9a-f]+\"",
            "\"hierarchyHash\": \"" + ContentHash.Of(bytes).ToString("x16") + "\""));
    }

    static unsafe void AddPlanes(OldTable table, int planes, List<ulong> hashes)
    {
        for (int i = 0; i < table.NodeCount; i++)
            for (int p = 0; p < planes; p++)
                if (table.RangesOf(i)[p].LengthBytes > 0)
                    hashes.Add(table.RangesOf(i)[p].Hash);
    }

    static long BytesOf(string folder) => FilesOf(folder).Sum(f => new FileInfo(f).Length);

    static string[] FilesOf(string folder) => Directory.GetFiles(folder, "*", SearchOption.AllDirectories);
}
