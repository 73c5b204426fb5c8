namespace FastPoints.HostTests.Samples;

/// <summary>The menu commands of samples, and the scan that their scenes show.</summary>
public sealed class SampleSceneTests
{
    EditorProject m_project;

    [SetUp]
    public void OpenProject() => m_project = new EditorProject();

    /// <summary>The package's street in the project, as Unity finds it there.</summary>
    void PutPackagedStreet()
    {
        string path = m_project.Paths.Absolute(SampleScan.PackagedPath);
        Directory.CreateDirectory(Path.GetDirectoryName(path));
        File.Copy(Path.Combine(Checkout.Repository.Root, SampleScan.PackagedPath), path);
    }

    [TearDown]
    public void CloseProject()
    {
        EditorApplication.isPlaying = false;
        Debug.s_sink = null;
        EditorSceneManager.s_goesOn = true;
        m_project.Dispose();
    }

    static MethodInfo[] Commands() => Assembly.Load("FastPoints.Samples.Editor").GetTypes()
        .SelectMany(t => t.GetMethods(BindingFlags.Static | BindingFlags.NonPublic))
        .Where(m => m.GetCustomAttribute<MenuItem>() != null).ToArray();

    internal static MethodInfo Command(string name) =>
        Commands().Single(m => m.GetCustomAttribute<MenuItem>().menuItem == name);

    static string[] Names() => Commands().Select(m => m.GetCustomAttribute<MenuItem>().menuItem).ToArray();

    string Street => m_project.Paths.Absolute("PointClouds/street.laz");

    /// <summary>A smaller one in its place: what is there is not copied again.</summary>
    void PutSmallStreet()
    {
        Directory.CreateDirectory(Path.GetDirectoryName(Street));
        m_project.Scratch.Demo("project/PointClouds/street.laz", 3000);
    }

    static void Updates(Func<bool> isDone) => ImportProject.Updates(() => EditorApplication.update?.Invoke(), isDone);

    [TestCaseSource(nameof(Names))]
    public void Command_OfASample_CreatesItsScene(string name)
    {
        PutSmallStreet();
        Camera.main = null;

        Commands().Single(m => m.GetCustomAttribute<MenuItem>().menuItem == name).Invoke(null, null);
        Updates(() => Camera.main != null);

        Assert.That(m_project.Asset(SampleScan.AssetPath), Is.Not.Null);
        Assert.That(Camera.main.transform.position.y, Is.GreaterThan(0));
    }

    [Test]
    public void Command_OfASample_ClosesTheSceneBefore()
    {
        PutSmallStreet();
        var before = new GameObject("of the scene before");
        Camera.main = null;
        Commands()[0].Invoke(null, null);
        Updates(() => Camera.main != null);
        Assert.That(before == null, Is.True);
    }

    /// <summary>After any failure the next request starts over.</summary>
    [Test]
    public void Get_UnwritableFolder_ReportsItAndCanBeRetried()
    {
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        string folder = Path.GetDirectoryName(Street);
        File.WriteAllText(folder, "no folder");
        Assert.That(SampleScan.GetOrImport(), Is.Null);
        Assert.That(logged.Single(), Does.StartWith("Error: FastPoints: " + Street));
        File.Delete(folder);
        PutSmallStreet();
        Assert.That(SampleScan.GetOrImport(), Is.Not.Null);
    }

    [Test]
    public void Commands_OfSamples_AreOneForEachListedSample()
    {
        string package = Checkout.Repository.PackageRoot;
        using JsonDocument manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(package, "package.json")));
        var listed = manifest.RootElement.GetProperty("samples").EnumerateArray()
            .Select(s => (Path: s.GetProperty("path").GetString(), Name: s.GetProperty("displayName").GetString())).ToArray();

        Assert.That(listed.Select(s => s.Path), Is.EquivalentTo(Directory.GetDirectories(Path.Combine(package, "Samples~"))
            .Select(d => "Samples~/" + Path.GetFileName(d))));
        Assert.That(Names(), Is.EquivalentTo(listed.Select(s => "FastPoints/Samples/" + s.Name)));
        Assert.That(listed.Where(s => !File.Exists(Path.Combine(package, s.Path, "README.md"))), Is.Empty);
    }

    [Test]
    public void AttributeColours_Scene_HasTheSwitchOnTheCloud()
    {
        PutSmallStreet();

        Commands().Single(m => m.GetCustomAttribute<MenuItem>().menuItem.EndsWith("Attribute colours")).Invoke(null, null);
        Updates(() => Selection.activeObject is GameObject o && o.GetComponent<ColourSwitch>() != null);

        var cloud = ((GameObject)Selection.activeObject).GetComponent<FastPoints.Entities.PointCloud>();
        Assert.That(cloud.Cloud, Is.SameAs(m_project.Asset(SampleScan.AssetPath)));
    }

    [Test]
    public void Create_UserKeepsTheScene_CreatesNothing()
    {
        PutSmallStreet();
        EditorSceneManager.s_goesOn = false;
        Camera.main = null;
        bool isFilled = false;

        SampleScene.Create(_ => isFilled = true);
        Updates(() => m_project.Asset(SampleScan.AssetPath) != null);

        Assert.That(Camera.main, Is.Null);
        Assert.That(isFilled, Is.False);
    }

    /// <summary>In play mode Unity makes no scenes: it throws.</summary>
    [Test]
    public void Create_InPlayMode_ReportsItAndCreatesNothing()
    {
        PutSmallStreet();
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        bool isFilled = false;

        EditorApplication.isPlaying = true;
        SampleScene.Create(_ => isFilled = true);

        Assert.That(logged.Single(), Does.StartWith("Warning: FastPoints: ").And.Contains("play mode"));
        Assert.That(isFilled, Is.False);
        Assert.That(() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single),
            Throws.InvalidOperationException);
    }

    [Test]
    public void Get_CalledRepeatedly_CreatesOneAsset()
    {
        PutSmallStreet();

        var got = new[] { SampleScan.GetOrImport(), SampleScan.GetOrImport(), SampleScan.GetOrImport() };

        Assert.That(got[0], Is.Not.Null);
        Assert.That(got.Distinct().Count(), Is.EqualTo(1));
        Assert.That(Directory.GetFiles(Path.Combine(m_project.Paths.Project, "Assets"), "*.pointcloud"), Has.Length.EqualTo(1));
    }

    /// <summary>What the scan is, and its source, are for nobody's version control.</summary>
    [Test]
    public void Get_NewProject_CreatesTheDataFolder()
    {
        PutPackagedStreet();
        SampleScan.GetOrImport();
        Assert.That(File.ReadAllLines("PointClouds/.gitignore"), Does.Contain("*"));
    }

    /// <summary>A clone of a team's project has the asset but not the scan.</summary>
    [Test]
    public void Get_AssetWithoutItsScan_CreatesItAgain()
    {
        PutSmallStreet();
        var got = SampleScan.GetOrImport();
        m_project.UpdateToTheEnd();
        AssemblyReloadEvents.Reload();
        Directory.Delete("PointClouds", true);
        PutPackagedStreet();

        var again = SampleScan.GetOrImport();
        m_project.UpdateToTheEnd();

        Assert.That(again, Is.SameAs(got));
        Assert.That(File.Exists("PointClouds/street.fastpoints/cloud.json"));
    }

    [Test]
    public void Get_NoSample_CopiesThePackagesStreet()
    {
        PutPackagedStreet();

        var asset = SampleScan.GetOrImport();

        Assert.That(File.ReadAllBytes(Street), Is.EqualTo(File.ReadAllBytes(m_project.Paths.Absolute(SampleScan.PackagedPath))));
        Assert.That(asset, Is.SameAs(m_project.Asset(SampleScan.AssetPath)));
        using var reader = PointReaders.Open(Street);
        Assert.That(reader.Info.PointsClaimed, Is.EqualTo(200_000ul));
    }

    /// <summary>The scene's command finds the sample's street by its GUID.</summary>
    [Test]
    public void RunTimeLoading_Street_HasTheGuidOfItsCommand()
    {
        string meta = Path.Combine(Checkout.Repository.Root, SampleScan.PackagedPath + ".meta");
        string command = Path.Combine(Path.GetDirectoryName(meta), "Editor/RunTimeLoadingScene.cs");
        string guid = File.ReadAllLines(meta).Single(l => l.StartsWith("guid: "))["guid: ".Length..];
        Assert.That(File.ReadAllText(command), Does.Contain('"' + guid + '"'));
    }
}
