namespace FastPoints.HostTests.Repository;

/// <summary>A project draws with the pipeline that its settings name, and not with one because its package is there. Its
/// scripts are compiled with the generations.</summary>
public sealed class ProjectSetupTests
{
    static string[] Projects() => Directory.GetDirectories(Path.Combine(Checkout.Repository.Root, "Projects"))
        .Select(Path.GetFileName)
        .Order().ToArray();

    static string Read(string project, string file)
    {
        string path = Path.Combine(Checkout.Repository.Root, "Projects", project, file);
        Assert.That(path, Does.Exist);
        return File.ReadAllText(path);
    }

    [TestCaseSource(nameof(Projects))]
    public void Project_WithAPipelinesPackage_NamesItsAssetAndTestsThatItIsUsed(string project)
    {
        string[] packages = JsonDocument.Parse(Read(project, "Packages/manifest.json")).RootElement.GetProperty("dependencies")
            .EnumerateObject().Select(p => p.Name).ToArray();
        string asset = packages.Contains("com.unity.render-pipelines.universal") ? "UniversalRenderPipelineAsset"
            : packages.Contains("com.unity.render-pipelines.high-definition") ? "HDRenderPipelineAsset" : null;
        string setup = Read(project, "Assets/Editor/ProjectSetup.cs");

        Assert.That(setup, Does.Contain("PlayerSettings.colorSpace = ColorSpace.Linear;"));
        Assert.That(setup, asset == null ? Does.Not.Contain("defaultRenderPipeline")
            : Does.Contain("GraphicsSettings.defaultRenderPipeline = ").And.Contain("LoadAssetAtPath<" + asset + ">"));
        Assert.That(Read(project, "Assets/Tests/PipelineTests.cs"),
            Does.Contain("GraphicsSettings.currentRenderPipeline, "
                + (asset == null ? "Is.Null" : "Is.TypeOf<" + asset + ">()")));
    }
}
