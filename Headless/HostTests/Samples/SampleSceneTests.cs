using System.Reflection;
using FastPoints.HostTests.Editor;
using FastPoints.Samples.AttributeColours;
using UnityEditor.SceneManagement;

namespace FastPoints.HostTests.Samples;

public sealed class SampleSceneTests
{
    EditorProject m_project;

    [SetUp]
    public void OpenProject() => m_project = new EditorProject();

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

    string Street => m_project.Paths.Absolute("PointClouds/street.las");

    void PutSmallStreet()
    {
        Directory.CreateDirectory(Path.GetDirectoryName(Street));
        m_project.Scratch.Demo("project/PointClouds/street.las", 3000);
    }

    static void Updates(Func<bool> isDone) => ImportProject.Updates(() => EditorApplication.update?.Invoke(), isDone);

    [TestCaseSource(nameof(Names))]
    public void Command_OfASample_MakesItsScene(string name)
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

    [Test]
    public void Get_PlaceThatCannotBeMade_ReportsItAndCanBeAskedAgain()
    {
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        string place = Path.GetDirectoryName(Street);
        File.WriteAllText(place, "no folder");
        int got = 0;
        SampleScan.Get(_ => got++);
        Assert.That(logged.Single(), Does.StartWith("Error: FastPoints: " + Street));
        File.Delete(place);
        PutSmallStreet();
        SampleScan.Get(_ => got++);
        Updates(() => got > 0);
        Assert.That(got, Is.EqualTo(1));
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
    public void Make_UserKeepsHisScene_NothingIsMade()
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
    [TestCase(true)]
    [TestCase(false)]
    public void Make_InPlayMode_ReportsItAndMakesNothing(bool fromTheStart)
    {
        PutSmallStreet();
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        bool isFilled = false;

        EditorApplication.isPlaying = fromTheStart;
        SampleScene.Create(_ => isFilled = true);
        EditorApplication.isPlaying = true;
        Updates(() => logged.Count > 0);

        Assert.That(logged.Single(), Does.StartWith("Warning: FastPoints: ").And.Contains("play mode"));
        Assert.That(isFilled, Is.False);
        Assert.That(() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single),
            Throws.InvalidOperationException);
    }

    [Test]
    public void Get_AskedTwiceAndAgain_MakesOneAsset()
    {
        PutSmallStreet();
        var got = new List<PointCloudAsset>();

        SampleScan.Get(got.Add);
        SampleScan.Get(got.Add);
        Updates(() => got.Count == 2);
        SampleScan.Get(got.Add);

        Assert.That(got, Has.Count.EqualTo(3));
        Assert.That(got.Distinct().Count(), Is.EqualTo(1));
        Assert.That(Directory.GetFiles(Path.Combine(m_project.Paths.Project, "Assets"), "*.pointcloud"), Has.Length.EqualTo(1));
    }

    [Test]
    public void Get_MakesThePlaceAsOthersDo()
    {
        SampleScan.Get(_ => { });
        AssemblyReloadEvents.Reload();
        Assert.That(File.ReadAllLines("PointClouds/.gitignore"), Does.Contain("*"));
    }

    [Test]
    public void Get_AssetWithoutItsScan_MakesItAgain()
    {
        PutSmallStreet();
        PointCloudAsset got = null;
        SampleScan.Get(asset => got = asset);
        Updates(() => got != null);
        m_project.UpdateToTheEnd();
        AssemblyReloadEvents.Reload();
        Directory.Delete("PointClouds", true);
        PointCloudAsset again = null;

        SampleScan.Get(asset => again = asset);
        Assert.That(again, Is.Null, "the scan first");
        Updates(() => again != null);
        m_project.UpdateToTheEnd();

        Assert.That(again, Is.SameAs(got));
        Assert.That(File.Exists("PointClouds/street.fastpoints/cloud.json"));
    }

    [Test]
    public void Get_ScriptsReloadedMidway_LeavesNothing()
    {
        bool isMade = false;
        SampleScan.Get(_ => isMade = true);
        Updates(() => Directory.GetFiles(Path.GetDirectoryName(Street)).Length > 0);

        AssemblyReloadEvents.Reload();

        Assert.That(Directory.GetFiles(Path.GetDirectoryName(Street), "street*"), Is.Empty);
        Assert.That(isMade, Is.False);
        Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Canceled));
    }
}
