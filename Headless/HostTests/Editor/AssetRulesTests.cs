namespace FastPoints.HostTests.Editor;

public sealed class AssetRulesTests : EditorFixture
{
    const string Path = "Assets/rule.rule";

    static int s_imports;

    [SetUp]
    public void AddImporter()
    {
        s_imports = 0;
        RuleImporter.Imports = _ => s_imports++;
        ImporterTable.Add(typeof(RuleImporter), new[] { "rule" }, null);
        File.WriteAllText(m_project.Paths.Absolute(Path), "one");
        AssetDatabase.Refresh();
        s_imports = 0;
    }

    [Test]
    public void ImportAsset_Unchanged_DoesNothingUnlessForced()
    {
        AssetDatabase.ImportAsset(Path);
        AssetImporter.GetAtPath(Path).SaveAndReimport();
        AssetDatabase.Refresh();
        Assert.That(s_imports, Is.Zero);
        AssetDatabase.ImportAsset(Path, ImportAssetOptions.ForceUpdate);
        Assert.That(s_imports, Is.GreaterThan(0));
        s_imports = 0;
        File.WriteAllText(m_project.Paths.Absolute(Path), "two");
        AssetDatabase.ImportAsset(Path);
        Assert.That(s_imports, Is.GreaterThan(0));
    }

    [Test]
    public void ImportAsset_AgainOfAChangedFile_IsTheSameObject()
    {
        var before = AssetDatabase.LoadAssetAtPath<RuleAsset>(Path);
        File.WriteAllText(m_project.Paths.Absolute(Path), "longer");
        AssetDatabase.ImportAsset(Path);
        Assert.That(AssetDatabase.LoadAssetAtPath<RuleAsset>(Path), Is.SameAs(before));
        Assert.That(before.Length, Is.EqualTo(6));
    }

    [Test]
    public void Importer_UsingASingleton_IsRejected()
    {
        RuleImporter.Imports = _ => Assert.That(AssetDatabase.IsAssetImportWorkerProcess(), Is.True);
        AssetDatabase.ImportAsset(Path, ImportAssetOptions.ForceUpdate);
        RuleImporter.Imports = _ => FastPointsSettings.instance.Apply();
        Assert.That(() => AssetDatabase.ImportAsset(Path, ImportAssetOptions.ForceUpdate), Throws.InvalidOperationException);
        Assert.That(AssetDatabase.IsAssetImportWorkerProcess(), Is.False);
    }

    [Test]
    public void Importer_NotDeterministic_IsRejected()
    {
        RuleImporter.Imports = asset => asset.Length = ++s_imports;
        Assert.That(() => AssetDatabase.ImportAsset(Path, ImportAssetOptions.ForceUpdate),
            Throws.InvalidOperationException.With.Message.Contains("Length"));
    }

    [TestCase("a.rule.tmp")]
    [TestCase(".a.rule")]
    [TestCase("a.rule~")]
    [TestCase("Hidden~/a.rule")]
    [TestCase(".git/a.rule")]
    public void Refresh_HiddenFile_IsIgnored(string name)
    {
        string path = m_project.Paths.Absolute("Assets/" + name);
        Directory.CreateDirectory(System.IO.Path.GetDirectoryName(path));
        File.WriteAllText(path, "hidden");
        AssetDatabase.Refresh();
        Assert.That(s_imports, Is.Zero);
        Assert.That(AssetDatabase.AssetPathToGUID("Assets/" + name), Is.Empty);
    }

    [Test]
    public void Refresh_MissingFile_RemovesTheAsset()
    {
        File.Delete(m_project.Paths.Absolute(Path));
        AssetDatabase.Refresh();
        Assert.That(AssetDatabase.LoadAssetAtPath<RuleAsset>(Path), Is.Null);
        Assert.That(AssetDatabase.AssetPathToGUID(Path), Is.Empty);
    }

    [Test]
    public void SetImporterOverride_ImporterNotOffered_IsRefused()
    {
        AssetDatabase.SetImporterOverride<PointFileImporter>(Path);
        AssetDatabase.SetImporterOverride<PointFileImporter>("Assets/none.las");
        Assert.That(AssetDatabase.Overrides, Is.Empty);
        Assert.That(m_logged, Has.Count.EqualTo(2).And.All.Contains("Cannot set Importer override"));
    }

    [Test]
    public void ImporterTable_ExtensionClaimedTwice_HasNoImporter()
    {
        ImporterTable.Add(typeof(HandleImporter), new[] { "rule" }, null);
        Assert.That(AssetDatabase.GetDefaultImporter(Path), Is.EqualTo(typeof(AssetImporter)));
        Assert.That(m_logged, Has.Count.EqualTo(1).And.All.Contains("have all been rejected"));
    }

    [Test]
    public void Settings_NextSession_AreTheSavedOnes()
    {
        var settings = FastPointsSettings.instance;
        (settings.UpdateMs, settings.Sampler) = (7, Sampler.Poisson);
        settings.Save();
        settings.UpdateMs = 9;
        UnityEngine.Object.DestroyImmediate(settings);
        try
        {
            var next = FastPointsSettings.instance;
            Assert.That(next, Is.Not.SameAs(settings));
            Assert.That((next.UpdateMs, next.Sampler), Is.EqualTo((7, Sampler.Poisson)));
            Assert.That(next.hideFlags & HideFlags.NotEditable, Is.EqualTo(HideFlags.None));
        }
        finally
        {
            File.Delete(m_project.Paths.Absolute("ProjectSettings/FastPoints.asset"));
            UnityEngine.Object.DestroyImmediate(FastPointsSettings.instance);
        }
    }

    [Test]
    public void AddAdditionalPath_MissingOrForeignPath_IsRejected()
    {
        var context = new BuildPlayerContext(new BuildPlayerOptions());
        string one = m_project.Scratch["one.txt"], two = m_project.Scratch["two.txt"];
        File.WriteAllText(one, "");
        File.WriteAllText(two, "");
        Assert.That(() => context.AddAdditionalPathToStreamingAssets(m_project.Scratch["none"], "x"),
            Throws.TypeOf<FileNotFoundException>());
        context.AddAdditionalPathToStreamingAssets(one, "x");
        context.AddAdditionalPathToStreamingAssets(one, "x");
        Assert.That(() => context.AddAdditionalPathToStreamingAssets(two, "x"), Throws.ArgumentException);
    }

    sealed class RuleAsset : ScriptableObject
    {
        public int Length;
    }

    sealed class RuleImporter : ScriptedImporter
    {
        public static Action<RuleAsset> Imports;

        public override void OnImportAsset(AssetImportContext ctx)
        {
            var asset = ScriptableObject.CreateInstance<RuleAsset>();
            asset.Length = (int)new FileInfo(ctx.assetPath).Length;
            Imports(asset);
            ctx.AddObjectToAsset("rule", asset);
            ctx.SetMainObject(asset);
        }
    }
}
