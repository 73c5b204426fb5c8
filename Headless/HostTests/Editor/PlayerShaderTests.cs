using FastPoints.Cli.Draw;
using UnityEditor.Rendering;
using UnityEngine.Rendering;

namespace FastPoints.HostTests.Editor;

public sealed class PlayerShaderTests
{
    GpuShaders m_shaders;

    [SetUp]
    public void LoadShaders()
    {
        m_shaders = new GpuShaders();
        var resources = ScriptableObject.CreateInstance<PointCloudResources>();
        resources.Points = m_shaders.Points;
        resources.Progressive = m_shaders.Progressive;
        Resources.Assets[PointCloudResources.Path] = resources;
    }

    [TearDown]
    public void Reset()
    {
        Resources.Assets.Clear();
        FastPointsSettings.instance.ProgressiveInPlayers = true;
    }

    static ShaderCompilerData Variant(params string[] keywords) =>
        new ShaderCompilerData { shaderKeywordSet = new ShaderKeywordSet(keywords) };

    [TestCase(true)]
    [TestCase(false)]
    public void Build_WithoutSeveralFrames_LacksTheirShadersAlone(bool hasSeveralFrames)
    {
        FastPointsSettings.instance.ProgressiveInPlayers = hasSeveralFrames;
        var builder = new PlayerShaders();
        var progressive = new LocalKeyword(m_shaders.Points, ShaderNames.ProgressiveKeyword);
        var layered = new LocalKeyword(m_shaders.Points, ShaderNames.LayeredKeyword);
        var variants = new List<ShaderCompilerData>
        {
            Variant(ShaderNames.ProgressiveKeyword, ShaderNames.ClippedKeyword), Variant(ShaderNames.LayeredKeyword), Variant(),
            Variant(ShaderNames.ProgressiveKeyword),
        };
        builder.OnProcessShader(m_shaders.Points, default, variants);
        Assert.That(variants.Count(v => v.shaderKeywordSet.IsEnabled(progressive)), Is.EqualTo(hasSeveralFrames ? 2 : 0));
        Assert.That(variants.Count(v => v.shaderKeywordSet.IsEnabled(layered)), Is.EqualTo(1));
        Assert.That(variants, Has.Count.EqualTo(hasSeveralFrames ? 4 : 2));

        var kernels = new List<ShaderCompilerData> { Variant() };
        builder.OnProcessComputeShader(m_shaders.Raster, ShaderNames.RasterDepthKernel, kernels);
        builder.OnProcessShader(m_shaders.Compose, default, kernels);
        Assert.That(kernels, Has.Count.EqualTo(1), "others' shaders");
        builder.OnProcessComputeShader(m_shaders.Progressive, ShaderNames.RasterDepthKernel, kernels);
        Assert.That(kernels, Has.Count.EqualTo(hasSeveralFrames ? 1 : 0));
    }
}
