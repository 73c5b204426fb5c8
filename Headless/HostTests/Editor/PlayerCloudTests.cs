namespace FastPoints.HostTests.Editor;

public sealed class PlayerCloudTests : EditorFixture
{
    const string ScenePath = "Assets/main.unity";

    [SetUp]
    public void ReferToACloud() => AssetDatabase.Dependencies[ScenePath] = new[] { "Assets/a.pointcloud", "Assets/other.mat" };

    [TearDown]
    public void CloseScene() => (SceneManager.s_active, Application.isBatchMode) = (default, false);

    void Take(params string[] names)
    {
        for (int i = 0; i < names.Length; i++)
            m_project.Imports.CreateAsset(m_project.Scratch.Demo(names[i] + ".las", 2000 + 1000 * i), "Assets");
    }

    BuildPlayerContext Build() => Build(new[] { ScenePath });

    static BuildPlayerContext Build(string[] scenes)
    {
        var context = new BuildPlayerContext(new BuildPlayerOptions { scenes = scenes });
        foreach (var processor in new BuildPlayerProcessor[] { new PlayerCloudProcessor(), new BatchCloudProcessor() }
            .OrderBy(p => p.callbackOrder))
            processor.PrepareForBuild(context);
        return context;
    }

    [Test]
    public void Build_CloudsUsedByScenes_AreTheOnlyOnesAdded()
    {
        Take("a", "b");
        m_project.UpdateToTheEnd();

        var added = Build().FolderOfPlayerPath;

        Assert.That(added.Single().Key, Is.EqualTo("PointClouds/a.fastpoints"));
        Assert.That(added.Single().Value, Is.EqualTo(Path.Combine(m_project.Paths.Clouds, "a.fastpoints")));
        Assert.That(m_logged.Single(), Does.StartWith("Log: 1 point clouds in the player, 0.")
            .And.Contains("2,000 points  PointClouds/a.fastpoints"));
    }

    /// <summary>A scene may refer to thousands of textures and meshes.</summary>
    [Test]
    public void Build_OtherAssets_AreNotLoaded()
    {
        Take("a");
        m_project.UpdateToTheEnd();
        AssetDatabase.Assets["Assets/other.mat"] = new DefaultAsset();
        int before = AssetDatabase.s_loads;

        Build();

        Assert.That(AssetDatabase.s_loads - before, Is.EqualTo(1));
    }

    static readonly string[][] s_noScenes = { null, new string[0] };

    [TestCaseSource(nameof(s_noScenes))]
    public void Build_NoScenesNamed_AddsTheCloudsOfTheOpenOne(string[] none)
    {
        Take("a", "b");
        m_project.UpdateToTheEnd();
        SceneManager.s_active = new Scene { Path = ScenePath };

        var context = Build(none);

        Assert.That(context.BuiltScenes, Is.EqualTo(new[] { ScenePath }));
        Assert.That(context.FolderOfPlayerPath.Keys, Is.EqualTo(new[] { "PointClouds/a.fastpoints" }));
    }

    [TestCase("Assets/menu.unity", "of 2 in the project: neither Assets/menu.unity nor")]
    [TestCase(null, "of 2 in the project: neither a scene nor")]
    public void Build_NoCloudIncluded_ReportsIt(string scene, string said)
    {
        Take("a", "b");
        m_project.UpdateToTheEnd();

        var context = Build(scene == null ? null : new[] { scene });

        Assert.That(context.FolderOfPlayerPath, Is.Empty);
        Assert.That(m_logged.Single(), Does.StartWith("Warning: FastPoints: no point cloud in the player").And.Contains(said));
    }

    [Test]
    public void Build_UnconvertedCloud_FailsTheBuild()
    {
        Take("a");
        Assert.That(Build,
            Throws.TypeOf<BuildFailedException>().With.Message.StartsWith("Assets/a.pointcloud: is not converted"));

        m_project.UpdateToTheEnd();
        string folder = Path.Combine(m_project.Paths.Clouds, "a.fastpoints");
        Directory.Move(folder, folder + StoreFormat.UnfinishedSuffix);
        Assert.That(Build, Throws.TypeOf<BuildFailedException>().With.Message.Contains("got one in the making")
            .And.Message.Contains("FastPoints > Clouds"), "what helps");
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Build_InBatchMode_ConvertsWhatItNeedsOrNamesTheMissingSource(bool isHere)
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        Take("a", "b");
        Application.isBatchMode = true;
        if (!isHere)
            File.Delete(m_project.Scratch["a.las"]);
        Assert.That(Build, isHere ? Throws.Nothing : (NUnit.Framework.Constraints.IResolveConstraint)Throws
            .TypeOf<BuildFailedException>().With.Message.Contains("1 of 1 point clouds").And.Message.Contains("a.las"));
        Assert.That(File.Exists("PointClouds/a.fastpoints/cloud.json"), Is.EqualTo(isHere));
        Assert.That(Directory.Exists("PointClouds/b.fastpoints"), Is.False, "the player does not have it");
    }

    /// <summary>A build server may keep its data, and another of the team convert again.</summary>
    [Test]
    public void Build_OutdatedCloud_IsConvertedAgainOrFailsTheBuild([Values] bool isBatch)
    {
        m_project.Pull("a");
        Application.isBatchMode = isBatch;
        if (isBatch)
            Assert.That(File.ReadAllText(Build().FolderOfPlayerPath.Single().Value + "/cloud.json"), Does.Contain("3000"));
        else
            Assert.That(Build, Throws.TypeOf<BuildFailedException>().With.Message.StartsWith("Assets/a.pointcloud: ")
                .And.Message.Contains("converted again").And.Message.Contains("FastPoints > Clouds"));
    }

    [Test]
    public void Build_ForTheWeb_FailsWithOneLine()
    {
        void BuildFor(string scene, BuildTarget target = BuildTarget.WebGL) => new PlayerCloudProcessor().PrepareForBuild(
            new BuildPlayerContext(new BuildPlayerOptions { scenes = new[] { scene }, target = target }));
        Take("a");
        m_project.UpdateToTheEnd();
        Assert.That(() => BuildFor(ScenePath), Throws.TypeOf<BuildFailedException>().With.Message
            .StartsWith("FastPoints: players for WebGL cannot open").And.Message.Contains("PointClouds/a.fastpoints")
            .And.Message.Not.Contains("\n"));
        Assert.That(() => BuildFor("Assets/menu.unity"), Throws.Nothing, "without a cloud");
        Assert.That(() => BuildFor(ScenePath, BuildTarget.Android), Throws.Nothing);
    }

    [Test]
    public void Build_CloudsAboveTheSizeSetting_AreWarnedOf()
    {
        string source = m_project.Copc("a.copc.laz");
        AssetDatabase.Dependencies[ScenePath] = new[] { "Assets/a.copc.pointcloud" };
        m_project.Imports.CreateAsset(source, "Assets");
        using (var file = File.OpenWrite(source))
            file.SetLength(3 << 20);
        var settings = FastPointsSettings.instance;
        foreach (var (limitMiB, warns) in new[] { (3, true), (4, false), (0, false) })
        {
            m_logged.Clear();
            settings.PlayerWarningMiB = limitMiB;
            Build();
            Assert.That(m_logged.Count(l => l.Contains("point clouds have 3 MiB")), Is.EqualTo(warns ? 1 : 0));
        }
    }

    [Test]
    public void Build_NoScene_AddsTheResources()
    {
        Take("a", "b");
        m_project.UpdateToTheEnd();
        Directory.CreateDirectory("Assets/Resources");
        File.Copy("Assets/b.pointcloud", "Assets/Resources/b.pointcloud");
        AssetDatabase.Refresh();

        Assert.That(Build().FolderOfPlayerPath.Keys,
            Is.EquivalentTo(new[] { "PointClouds/a.fastpoints", "PointClouds/b.fastpoints" }));
    }

    [Test]
    public void Build_CloudsNamedInSettings_AreAddedOnce()
    {
        Take("a", "b");
        m_project.UpdateToTheEnd();
        string guid = AssetDatabase.AssetPathToGUID("Assets/b.pointcloud");
        FastPointsSettings.instance.AlwaysInPlayers = [guid, "an asset that is gone"];

        Assert.That(Build().FolderOfPlayerPath.Keys,
            Is.EquivalentTo(new[] { "PointClouds/a.fastpoints", "PointClouds/b.fastpoints" }));
        Assert.That(m_logged, Has.Some.StartsWith("Warning: ").And.Some.Contains("an asset that is gone"));
    }

    [Test]
    public void Build_CloudStreamedFromItsSource_IsCopiedUnchanged()
    {
        string source = m_project.Copc("a.copc.laz");
        AssetDatabase.Dependencies[ScenePath] = new[] { "Assets/a.copc.pointcloud", "Assets/a.pointcloud" };
        var asset = m_project.Imports.CreateAsset(source, "Assets");

        var added = Build().FolderOfPlayerPath;

        Assert.That(added.Single().Key, Is.EqualTo(asset.PlayerSource));
        Assert.That(added.Single().Value, Is.EqualTo(source));
        Assert.That(m_logged.Single(), Does.Contain("as it is, with FastPoints.Import"));
        string link = new PlayerReaderLinker().GenerateAdditionalLinkXmlFile(null, null);
        var kept = XDocument.Load(link).Root.Element("assembly");
        Assert.That(System.Reflection.Assembly.Load((string)kept.Attribute("fullname"))
            .GetType((string)kept.Element("type").Attribute("fullname")),
            Is.EqualTo(typeof(FastPoints.Sources.PointFileReaders)));
        File.Delete(source);
        Assert.That(Build, Throws.TypeOf<BuildFailedException>().With.Message.Contains("neither converted"));
    }

    [Test]
    public void Build_NoClouds_LogsNothing()
    {
        Assert.That(Build().FolderOfPlayerPath, Is.Empty);
        Assert.That(m_logged, Is.Empty);
        Assert.That(new PlayerReaderLinker().GenerateAdditionalLinkXmlFile(null, null), Is.Null);
    }

    [Test]
    public void Add_TwoCloudsForOneFolder_ReportsTheAsset()
    {
        Take("a", "b");
        m_project.UpdateToTheEnd();
        string a = Path.Combine(m_project.Paths.Clouds, "a.fastpoints");
        string b = Path.Combine(m_project.Paths.Clouds, "b.fastpoints");
        var clouds = new PlayerClouds();
        clouds.Add("Assets/a.pointcloud", a, "PointClouds/a.fastpoints");
        clouds.Add("Assets/again.pointcloud", a, "PointClouds/a.fastpoints");
        Assert.That(clouds.Entries, Has.Count.EqualTo(1));
        Assert.That(() => clouds.Add("Assets/b.pointcloud", b, "pointclouds/A.fastpoints"),
            Throws.TypeOf<FastPoints.PointCloudException>().With.Message.StartsWith("Assets/b.pointcloud: "));
    }
}
