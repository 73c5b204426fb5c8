using UnityEditor.Build;
using UnityEditor.Compilation;
using UnityEditor.SceneManagement;
using UnityEngine.SceneManagement;
using KeywordVariant = StandIns.Graphics.KeywordVariant;

namespace FastPoints.HostTests.Editor;

/// <summary>Which variants of the package's shaders go into a player.</summary>
public sealed class PlayerShaderTests : EditorFixture
{
    const string ScenePath = "Assets/main.unity";
    const string OfPackage = "Packages/com.fastpoints.dots/Runtime/FastPoints.Entities/Authoring/PointCloudSettings.cs";

    readonly PlayerShaderProcessor m_processor = new PlayerShaderProcessor();
    GameObject m_root;

    [SetUp]
    public void MakeScene()
    {
        m_root = new GameObject("root");
        AssetDatabase.Dependencies[ScenePath] = new[] { OfPackage };
        Write(ScenePath, "%YAML 1.1\n  m_EditorClassIdentifier: FastPoints.Entities::FastPoints.Entities.PointCloudSettings\n");
        EditorSceneManager.Scenes[ScenePath] = new[] { m_root };
        EditorSceneManager.Opened.Clear();
        BuildPipeline.isBuildingPlayer = true;
    }

    [TearDown]
    public void DeleteScene()
    {
        BuildPipeline.isBuildingPlayer = false;
        SceneManager.s_active = default;
        EditorSceneManager.Scenes.Clear();
        CompilationPipeline.Assemblies.Clear();
        AssetDatabase.AssetBundleNames.Clear();
        Object.DestroyImmediate(m_root);
    }

    static Shader Load(string name) =>
        HeadlessShaders.Load(Path.Combine(Checkout.Repository.PackageRoot, "Shaders", name + ".shader"));

    void Write(string asset, string text)
    {
        string path = m_project.Paths.Absolute(asset);
        Directory.CreateDirectory(Path.GetDirectoryName(path));
        File.WriteAllText(path, text);
    }

    void Prepare(params string[] scenes) => Prepare(BuildOptions.None, scenes);

    void Prepare(BuildOptions options, params string[] scenes) => m_processor.PrepareForBuild(new BuildPlayerContext(
        new BuildPlayerOptions { scenes = scenes, options = options, target = BuildTarget.StandaloneLinux64 }));

    /// <summary>Names of all variants that are built.</summary>
    List<string> BuildShaders() => new[] { "Points", "Compose" }.SelectMany(s => ShaderBuild.Build(Load(s), m_processor))
        .SelectMany(p => p.Value.Select(keywords => PlayerVariants.NameOf(p.Key, keywords))).ToList();

    List<string> Build(params string[] scenes)
    {
        Prepare(scenes);
        var built = BuildShaders();
        m_processor.OnPostprocessBuild(null);
        return built;
    }

    PointCloudSettings Settings(PointShape shape)
    {
        var settings = m_root.AddComponent<PointCloudSettings>();
        settings.Shape = shape;
        return settings;
    }

    [Test]
    public void Build_SceneWithoutSettings_HasWhatTheDefaultNeeds()
    {
        Assert.That(Build(ScenePath), Is.EquivalentTo(new[] { "Points FASTPOINTS_SQUARES", "Compose" }));
        Assert.That(m_logged.Single(),
            Is.EqualTo("Log: FastPoints: 2 of 107 variants of the point shaders: as the built scenes draw points"));
        Assert.That(EditorSceneManager.s_previewScenes, Is.Zero);
    }

    [Test]
    public void Build_SettingsOfAScene_AddWhatTheyNeed()
    {
        var settings = Settings(PointShape.Splat);
        settings.SizeMode = PointSizeMode.Adaptive;
        m_root.AddComponent<PointCloudClipBox>();
        m_root.SetActive(false);

        Assert.That(Build(ScenePath), Is.EquivalentTo(new[]
        {
            "Points FASTPOINTS_SQUARES", "Points FASTPOINTS_CLIPPED FASTPOINTS_SQUARES",
            "Points FASTPOINTS_ADAPTIVE FASTPOINTS_DISCS FASTPOINTS_LAYERED",
            "Points FASTPOINTS_ADAPTIVE FASTPOINTS_CLIPPED FASTPOINTS_DISCS FASTPOINTS_LAYERED",
            "Blending FASTPOINTS_ADAPTIVE", "Blending FASTPOINTS_ADAPTIVE FASTPOINTS_CLIPPED", "Compose",
            "Compose FASTPOINTS_BLENDED",
        }));
    }

    [Test]
    public void Build_PixelsWithHiddenClassesAndHeadsets_HaveTheirs()
    {
        Settings(PointShape.Pixel);
        m_root.AddComponent<PointCloud>().HiddenClasses = new[] { 7 };
        CompilationPipeline.Assemblies.Add(new Assembly("Unity.XR.Management"));

        Assert.That(Build(ScenePath), Is.SupersetOf(new[]
        {
            "Points", "Points FASTPOINTS_FILTERED", "Points FASTPOINTS_STEREO",
            "Points FASTPOINTS_FILTERED FASTPOINTS_STEREO", "Compose FASTPOINTS_FROM_PIXELS",
        }).And.None.Contain("CLIPPED").And.None.Contain("LAYERED"));
    }

    [Test]
    public void Build_NoScenesNamed_HasWhatTheOpenOneNeeds()
    {
        Settings(PointShape.Paraboloid);
        SceneManager.s_active = new Scene { Path = ScenePath };

        Assert.That(Build(), Does.Contain("Points FASTPOINTS_PARABOLOIDS"));
    }

    [Test]
    public void Build_SettingsOfAPrefab_Count()
    {
        Settings(PointShape.Paraboloid);
        Write("Assets/Resources/look.prefab", "");
        AssetDatabase.Assets["Assets/Resources/look.prefab"] = m_root;
        AssetDatabase.Dependencies["Assets/Resources/look.prefab"] = new[] { OfPackage };

        Assert.That(Build(), Does.Contain("Points FASTPOINTS_PARABOLOIDS"));
    }

    [Test]
    public void Build_ScenesWithoutPoints_AreNotOpened()
    {
        AssetDatabase.Dependencies["Assets/menu.unity"] = new[] { "Assets/menu.mat" };

        Build("Assets/menu.unity", ScenePath);

        Assert.That(EditorSceneManager.Opened, Is.EqualTo(new[] { ScenePath }));
    }

    [TestCase("Assembly-CSharp", 0, ExpectedResult = 2, Description = "no such assembly is loaded")]
    [TestCase("FastPoints.Samples", 1, ExpectedResult = 2, Description = "of the package itself")]
    [TestCase("FastPoints.Samples", 0, ExpectedResult = 67)]
    public int Build_ScriptsThatMayChangeTheLook_HaveAllThatCanBeDrawn(string assembly, int isOfPackage)
    {
        System.Reflection.Assembly.Load("FastPoints.Samples");
        CompilationPipeline.Assemblies.Add(new Assembly(assembly, isOfPackage != 0 ? OfPackage : "Assets/look.cs"));

        return Build(ScenePath).Count;
    }

    [Test]
    public void Build_AssetBundles_HaveAllThatCanBeDrawn()
    {
        AssetDatabase.AssetBundleNames.Add("levels");

        Assert.That(Build(ScenePath), Has.Count.EqualTo(67));
        FastPointsSettings.instance.PlayerVariants = VariantChoice.BuiltScenes;
        Assert.That(Build(ScenePath), Has.Count.EqualTo(2));
    }

    [Test]
    public void Build_All_LeavesOutWhatNoDrawAsksFor()
    {
        FastPointsSettings.instance.PlayerVariants = VariantChoice.All;
        var every = new[] { "Points", "Compose" }.SelectMany(s => Load(s).Source.Passes).ToList();
        var existing = every.SelectMany(p => Enumerable.Range(0, (int)KeywordVariant.Count(p.Keywords))
            .Select(v => PlayerVariants.NameOf(p.Name, KeywordVariant.Names(p.Keywords, v, "vert")))).ToList();

        var built = Build(ScenePath);

        // Pixels have no adaptive size.
        Assert.That(existing.Except(built).ToList(), Has.Count.EqualTo(12).And.All.StartsWith("Points FASTPOINTS_ADAPTIVE")
            .And.None.Contain("SQUARES").And.None.Contain("DISCS").And.None.Contain("PARABOLOIDS"));
    }

    [Test]
    public void Process_NoPlayerIsBuilt_LeavesAllIn()
    {
        Prepare(ScenePath);
        BuildPipeline.isBuildingPlayer = false;

        Assert.That(BuildShaders(), Has.Count.EqualTo(107));
    }

    [TestCase("FastPoints.Entities.PointCloudSettings, FastPoints.Entities", 67)]
    [TestCase("FastPoints.Entities.PointCloudSettings,\n          FastPoints.Entities", 67)]
    [TestCase("UnityEngine.Behaviour, UnityEngine", 2)]
    [TestCase("MyFastPoints.Entities.Menu, MyGame", 2)]
    public void Build_EventThatCallsAComponent_HasAllThatCanBeDrawn(string target, int variants)
    {
        Write(ScenePath, "    m_Calls:\n      - m_TargetAssemblyTypeName: " + target + "\n");

        Assert.That(Build(ScenePath), Has.Count.EqualTo(variants));
        Assert.That(m_logged.Single().Contains("for " + ScenePath + " has an event"), Is.EqualTo(variants == 67));
        FastPointsSettings.instance.PlayerVariants = VariantChoice.BuiltScenes;
        Assert.That(() => Build(ScenePath), Has.Count.EqualTo(2));
    }

    [TestCase("Assets/menu.anim", OfPackage, ExpectedResult = 67)]
    [TestCase("Assets/menu.Playable", OfPackage, ExpectedResult = 67)]
    [TestCase("Assets/menu.anim", "Assets/menu.cs", ExpectedResult = 2)]
    [TestCase("Assets/menu.mat", OfPackage, ExpectedResult = 2)]
    public int Build_AnimationOfAComponent_HasAllThatCanBeDrawn(string asset, string moves)
    {
        AssetDatabase.Dependencies[ScenePath] = new[] { OfPackage, asset };
        AssetDatabase.Dependencies[asset] = new[] { moves };

        return Build(ScenePath).Count;
    }

    [Test]
    public void Prepare_EarlierShadersThatLackSomething_EndTheBuildBeforeItBegins()
    {
        void FromCache(BuildOptions options = BuildOptions.None)
        {
            m_logged.Clear();
            Prepare(options, ScenePath);
            m_processor.OnPostprocessBuild(null);
        }
        FromCache();
        Assert.That(m_logged, Is.Empty, "nobody knows of an earlier build: it had all");

        Build(ScenePath);
        FromCache();
        Assert.That(m_logged, Is.Empty);

        Settings(PointShape.Disc);
        Assert.That(() => FromCache(), Throws.TypeOf<BuildFailedException>().With.Message
            .EndsWith("Build once with Clean Build (BuildOptions.CleanBuildCache)").And.Message.Contains("as the built scenes"));
        Assert.That(BuildShaders(), Has.Count.EqualTo(107), "what goes on all the same takes nothing out");

        Prepare(BuildOptions.CleanBuildCache, ScenePath);
        BuildShaders();
        FromCache();
    }
}
