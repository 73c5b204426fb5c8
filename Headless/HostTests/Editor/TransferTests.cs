namespace FastPoints.HostTests.Editor;

public sealed class TransferTests : EditorFixture
{
    PointCloudAsset Converted(string name = "scan")
    {
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo(name + ".las", 20_000), "Assets");
        m_project.UpdateToTheEnd();
        return asset;
    }

    void Updates(Func<bool> isDone) => ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), isDone);

    static void AssertIsWhole(string cloud) =>
        Assert.That(CliCall.Of("verify", cloud, "--quiet").Status, Is.EqualTo(ExitStatus.Done));

    [Test]
    public void ExportCopy_ConvertedCloud_WritesItUnderItsOrTheNextFreeName()
    {
        var asset = Converted();
        string folder = Directory.CreateDirectory(m_project.Scratch["out"]).FullName;

        string first = m_project.Imports.ExportCopy(asset, folder), second = m_project.Imports.ExportCopy(asset, folder);
        Updates(() => !m_project.Imports.Transfers.IsCopying);

        Assert.That(first, Is.EqualTo(Path.Combine(folder, "scan.fastpoints")));
        Assert.That(second, Is.EqualTo(Path.Combine(folder, "scan 2.fastpoints")));
        AssertIsWhole(first);
        AssertIsWhole(second);
        Assert.That(Progress.Entries.TakeLast(2).Select(e => e.Status), Is.All.EqualTo(Progress.Status.Succeeded));
    }

    /// <summary>Windows' drives have letters: DriveInfo takes no \\server\share.</summary>
    [Test]
    public void ExportCopy_UnknownFreeSpace_WritesTheWholeCloud()
    {
        var asset = Converted();
        bool isAsked = false;
        using (WindowsRules.Hear((change, path, _) =>
        {
            if (change != FileChange.Measure)
                return;
            isAsked = true;
            throw new ArgumentException("Drive name must be a root directory (i.e. 'C:\\') or a drive letter ('C').");
        }))
        {
            string copy = m_project.Imports.ExportCopy(asset, Directory.CreateDirectory(m_project.Scratch["out"]).FullName);
            Updates(() => !m_project.Imports.Transfers.IsCopying);
            AssertIsWhole(copy);
        }
        Assert.That(isAsked, Is.True);
    }

    [Test]
    public void ExportCopy_CloudThatIsNotConverted_ReportsIt()
    {
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        asset.name = "scan";
        asset.ProjectPath = "PointClouds/none.fastpoints";
        Assert.That(m_project.Imports.ExportCopy(asset, m_project.Scratch["out"]), Is.Null);
        Assert.That(m_logged.Single(), Does.Contain("scan is not converted"));
    }

    [Test]
    public void ImportCopy_CloudOfAnotherProject_IsCopiedWithAnAsset()
    {
        Directory.CreateDirectory(m_project.Scratch["other"]);
        string other = m_project.Scratch.Converted("other/scan.fastpoints");

        m_project.Imports.ImportCopy(other, "Assets");
        Updates(() => !m_project.Imports.Transfers.IsCopying);

        var asset = (PointCloudAsset)Selection.activeObject;
        Assert.That(asset.ProjectPath, Is.EqualTo("PointClouds/scan.fastpoints"));
        Assert.That(asset.Points, Is.EqualTo(3000));
        AssertIsWhole(m_project.Paths.Absolute(asset.ProjectPath));
        Directory.Delete(other, true);
        Assert.That(m_project.Imports.Catalog.Find(m_project.Imports.HandleOf("Assets/scan.pointcloud"), out _),
            Is.EqualTo(CatalogMatch.InPlace));
    }

    [Test]
    public void ImportCopy_SomethingElseOrCancelled_LeavesNothing()
    {
        m_project.Imports.ImportCopy(m_project.Scratch["project"], "Assets");
        Assert.That(m_logged.Single(), Does.Contain("wanted a converted cloud"));
        var asset = Converted();
        m_logged.Clear();
        m_project.Imports.Transfers.ExportCopy(m_project.Paths.Absolute(asset.ProjectPath), m_project.Scratch["out"]);
        m_project.Imports.Suspend();
        Assert.That(m_project.Imports.Transfers.IsCopying, Is.False);
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void ExportCopy_CancelledInTheProgressWindow_IsNotReportedAgain()
    {
        var asset = Converted();
        string to = m_project.Imports.ExportCopy(asset, Directory.CreateDirectory(m_project.Scratch["out"]).FullName);

        Assert.That(Progress.Cancel(Progress.Entries.Count - 1), Is.True);
        Updates(() => !m_project.Imports.Transfers.IsCopying);

        Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Canceled));
        Assert.That(m_logged.Where(l => !l.Contains("copied to")), Is.Empty);
        m_project.Imports.ExportCopy(asset, m_project.Scratch["out"]);
        AssemblyReloadEvents.Reload();
        Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Canceled));
    }

    [TestCase("PointClouds", null)]
    [TestCase("Data/Clouds", null)]
    [TestCase("../elsewhere", null)]
    [TestCase("Assets/Clouds", "Assets is Unity's own")]
    [TestCase("library", "Library is Unity's own")]
    [TestCase(".", "with the project in it")]
    [TestCase("..", "with the project in it")]
    [TestCase(" ", "got nothing")]
    public void FindProblem_BadFolder_NamesTheProblem(string folder, string wanted)
    {
        string problem = ProjectPaths.FindProblem(m_project.Paths.Project, folder);
        Assert.That(problem, wanted == null ? Is.Null : Does.Contain(wanted));
    }

    [Test]
    public void Move_ToAnotherFolder_ConvertsThereAndKeepsOldClouds()
    {
        var before = Converted("before");
        Assert.That(PointCloudImports.SwitchConvertedRoot("Assets/x"), Does.Contain("Unity's own"));
        Assert.That(FastPointsSettings.instance.Place, Is.EqualTo("PointClouds"));

        Assert.That(PointCloudImports.SwitchConvertedRoot("Data/Clouds"), Is.Null);

        using (var imports = new EditorImports(PointCloudImports.ConfiguredPaths, FastPointsSettings.instance))
        {
            var after = imports.CreateAsset(m_project.Scratch.Demo("after.las", 3000), "Assets");
            Assert.That(after.ProjectPath, Is.EqualTo("Data/Clouds/after.fastpoints"));
            ImportProject.Updates(() => imports.Update(DateTime.UtcNow), () => imports.Queue.Requests.Count == 0);
            AssertIsWhole(m_project.Paths.Absolute(after.ProjectPath));
            Assert.That(after.PlayerPath, Does.StartWith("PointClouds/after-"), "a player has one place for all");
            Assert.That(imports.Catalog.Find(imports.HandleOf("Assets/before.pointcloud"), out _),
                Is.EqualTo(CatalogMatch.InPlace));
        }
        Assert.That(before.ProjectPath, Is.EqualTo("PointClouds/before.fastpoints"));
    }

    /// <summary>Importers know nothing of the place: their results may come from other machines.</summary>
    [Test]
    public void Move_ToAnotherFolder_FindsCloudsOfAssetsWithoutImport()
    {
        m_project.Scratch.Demo("project/Assets/tile.las", 3000);
        AssetDatabase.Refresh();
        var asset = m_project.Asset("Assets/tile.las");
        string folder = AssetDatabase.AssetPathToGUID("Assets/tile.las") + ".fastpoints";
        Assert.That(asset.Paths.FullPath, Is.EqualTo(m_project.Paths.Absolute("PointClouds/" + folder)));
        Assert.That(asset.PlayerPath, Is.EqualTo("PointClouds/" + folder));

        PointCloudImports.SwitchConvertedRoot("Data/Clouds");

        Assert.That(asset.Paths.FullPath, Is.EqualTo(m_project.Paths.Absolute("Data/Clouds/" + folder)));
        Assert.That(PointCloudImports.ConfiguredPaths.Absolute(asset.ProjectPath), Is.EqualTo(asset.Paths.FullPath));
        Assert.That(PointCloudImports.Current.HandleOf("Assets/tile.las").CloudPath, Is.EqualTo("Data/Clouds/" + folder));
    }

    [Test]
    public void Take_PointFileChangedSinceConversion_IsOfferedOnly()
    {
        string path = m_project.Paths.Absolute("Assets/tile.las");
        File.Move(m_project.Scratch.Demo("tile.las", 3000), path);
        AssetDatabase.Refresh();
        m_project.UpdateToTheEnd();
        Updates(() => !m_project.Imports.Thumbnails.IsDrawing);
        var handle = m_project.Imports.HandleOf("Assets/tile.las");
        Assert.That(handle.Stamp.Compare(new[] { path }), Is.EqualTo(SourceChange.None));

        File.SetLastWriteTimeUtc(path, DateTime.UtcNow.AddDays(1));
        m_project.Imports.CreatePointFileHandles(new[] { "Assets/tile.las" });
        Assert.That(m_logged, Is.Empty, "a time alone is no change");
        File.Copy(m_project.Scratch.Demo("other.las", 4000), path, true);
        m_project.Imports.CreatePointFileHandles(new[] { "Assets/tile.las" });
        Assert.That(m_logged.Single(), Does.Contain("Assets/tile.las has changed"));
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
        string cloud = m_project.Paths.Absolute(handle.CloudPath);
        CloudCatalog.Delete(cloud);
        Assert.That(File.Exists(StampFile.PathOf(cloud)), Is.False);
    }

    [Test]
    public void Move_BeforeTheFirstUpdate_MovesTheRequests()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("late.las", 2000), "Assets");
        Assert.That(PointCloudImports.SwitchConvertedRoot("Data/Clouds"), Is.Null);
        PointCloudImports.SwitchSourceRoot(m_project.Scratch["root"]);
        string cloud = PointCloudImports.ConfiguredPaths.Absolute(m_project.Imports.Queue.Requests.Single().Cloud);
        m_project.UpdateToTheEnd();
        Assert.That(CloudFolder.IsCloud(cloud), Is.True);
        PointCloudImports.SwitchSourceRoot("");
    }
}
