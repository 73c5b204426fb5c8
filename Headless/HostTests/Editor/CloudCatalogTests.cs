namespace FastPoints.HostTests.Editor;

public sealed class CloudCatalogTests : ScratchPerTest
{
    ProjectPaths m_paths;
    CloudCatalog m_catalog;

    [SetUp]
    public void MakeProject()
    {
        m_paths = new ProjectPaths(Scratch["project"]);
        m_catalog = new CloudCatalog(m_paths);
    }

    string Convert(string name, int points)
    {
        string target = Path.Combine(m_paths.Clouds, name + StoreFormat.FolderExtension);
        Directory.CreateDirectory(m_paths.Clouds);
        return Scratch.Converted(target, points);
    }

    CloudHandle Handle(string target) => new CloudHandle { CloudPath = m_paths.Stored(target) };

    [Test]
    public void Refresh_NoFolder_FindsNothing()
    {
        m_catalog.Refresh();
        Assert.That(m_catalog.Clouds, Is.Empty);
        var handle = Handle(Path.Combine(m_paths.Clouds, "a.fastpoints"));
        Assert.That(m_catalog.Find(handle, out _), Is.EqualTo(CatalogMatch.None));
    }

    [Test]
    public void Find_RenamedCloud_IsFoundByItsId()
    {
        var handle = Handle(Convert("one", 2000));
        Convert("two", 3000);
        m_catalog.Refresh();
        Assert.That(m_catalog.Clouds, Has.Count.EqualTo(2));
        Assert.That(m_catalog.Find(handle, out var cloud), Is.EqualTo(CatalogMatch.InPlace));
        Assert.That(cloud.Manifest.Points, Is.EqualTo(2000));
        handle.SetFrom(cloud.Manifest);

        Directory.Move(cloud.Path, Path.Combine(m_paths.Clouds, "renamed.fastpoints"));
        m_catalog.Refresh();
        Assert.That(m_catalog.Find(handle, out cloud), Is.EqualTo(CatalogMatch.Moved));
        Assert.That(cloud.Name, Is.EqualTo("renamed"));

        Directory.Delete(cloud.Path, true);
        Directory.Move(Path.Combine(m_paths.Clouds, "two.fastpoints"), m_paths.Absolute(handle.CloudPath));
        m_catalog.Refresh();
        Assert.That(m_catalog.Find(handle, out _), Is.EqualTo(CatalogMatch.Another));
    }

    [Test]
    public void Find_CloudOutsideTheDataFolder_IsFoundByPath()
    {
        string inside = Convert("one", 2000), outside = Scratch["far.fastpoints"];
        Directory.Move(inside, outside);
        m_catalog.Refresh();

        Assert.That(m_catalog.Find(Handle(outside), out var cloud), Is.EqualTo(CatalogMatch.InPlace));
        Assert.That(cloud.Manifest.Points, Is.EqualTo(2000));
    }

    [Test]
    public void Refresh_UnfinishedAndDamagedClouds_AreReportedAsSuch()
    {
        string broken = Convert("broken", 2000), building = Convert("building", 3000);
        File.WriteAllText(Path.Combine(broken, StoreFormat.ManifestName), "{}");
        Directory.Move(building, building + StoreFormat.UnfinishedSuffix);

        m_catalog.Refresh();

        Assert.That(m_catalog.Clouds, Has.Count.EqualTo(2));
        Assert.That(m_catalog.Clouds[0].Name, Is.EqualTo("broken"));
        Assert.That(m_catalog.Clouds[0].Problem, Does.Contain("missing"));
        Assert.That(m_catalog.Clouds[1].Path, Is.EqualTo(building));
        Assert.That(m_catalog.Clouds[1].IsUnfinished, Is.True);
        Assert.That(m_catalog.Find(Handle(building), out _), Is.EqualTo(CatalogMatch.Unfinished));
    }

    [Test]
    public void NewTarget_SourcesOfOneName_NeverCollide()
    {
        string taken = Convert("scan", 2000);
        var names = m_catalog.NewTargets(new[] { Path.Combine(m_paths.Clouds, "SCAN 3.fastpoints") });
        Assert.That(names.Next("SCAN"), Is.EqualTo(Path.Combine(m_paths.Clouds, "SCAN 2.fastpoints")));
        Assert.That(names.Next("scan"), Is.EqualTo(Path.Combine(m_paths.Clouds, "scan 4.fastpoints")), "3 is promised");

        Directory.Move(taken, taken + StoreFormat.UnfinishedSuffix);
        Assert.That(m_catalog.NewTargets(new string[0]).Next("scan"), Does.EndWith("scan 2.fastpoints"), "one in the making");
    }

    [Test]
    public void Delete_Cloud_LeavesNothing()
    {
        string target = Convert("one", 2000);
        Directory.CreateDirectory(target + StoreFormat.UnfinishedSuffix);

        CloudCatalog.Delete(target);

        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetFileSystemEntries(m_paths.Clouds), Is.Empty);
    }

    [Test]
    public void Copy_Cloud_IsTheSameInTheOtherProject()
    {
        string from = Convert("one", 2000), to = Scratch["other.fastpoints"];

        using (var copy = new CloudCopy(from, to))
        {
            copy.Work.GetAwaiter().GetResult();
            Assert.That(copy.Fraction, Is.EqualTo(1));
        }

        var verified = CliCall.Of("verify", to, "--against", Scratch["s2000.las"], "--quiet");
        Assert.That(verified.Status, Is.EqualTo(ExitStatus.Done), verified.Output + verified.Error);
    }

    [Test]
    public void Copy_ExistingTargetOrMissingSource_FailsAndLeavesNothing()
    {
        string from = Convert("one", 2000), to = Convert("two", 3000);

        Assert.That(() => new CloudCopy(from, to).Work.GetAwaiter().GetResult(),
            Throws.TypeOf<PointCloudException>().With.Message.Contains("already exists"));
        Assert.That(() => new CloudCopy(from + "-none", Scratch["x"]).Work.GetAwaiter().GetResult(),
            Throws.TypeOf<PointCloudException>().With.Property("Code").EqualTo(FailureCode.NotFound));
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories(m_paths.Clouds), Has.Length.EqualTo(2));
        Assert.That(CliCall.Of("verify", to, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
    }
}
