using UnityEditor.Rendering;

namespace FastPoints.HostTests.Editor;

public sealed class PlayerShaderTests
{
    [TearDown]
    public void Reset()
    {
        Resources.Assets.Clear();
        FastPointsSettings.instance.ProgressiveInPlayers = true;
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Build_WithoutProgressivePictures_LacksOnlyTheirShaders(bool isProgressive)
    {
        var shaders = new GpuShaders();
        var resources = ScriptableObject.CreateInstance<PointCloudResources>();
        (resources.Points, resources.Progressive) = (shaders.Points, shaders.Progressive);
        Resources.Assets[PointCloudResources.Path] = resources;
        FastPointsSettings.instance.ProgressiveInPlayers = isProgressive;

        int Built(Action<IList<ShaderCompilerData>> process)
        {
            var variants = new List<ShaderCompilerData>(new ShaderCompilerData[4]);
            process(variants);
            return variants.Count;
        }
        int BuiltOfPass(Shader shader, string pass) =>
            Built(v => new PlayerShaderStripper().OnProcessShader(shader, new ShaderSnippetData { passName = pass }, v));
        int BuiltOfKernels(ComputeShader shader) =>
            Built(v => new PlayerShaderStripper().OnProcessComputeShader(shader, ShaderNames.RasterDepthKernel, v));

        string[] passes = shaders.Points.Source.Passes.Select(p => p.Name).ToArray();
        Assert.That(passes.Select(pass => BuiltOfPass(shaders.Points, pass)),
            Is.EqualTo(new[] { 4, 4, isProgressive ? 4 : 0 }));
        Assert.That(passes.Select(pass => BuiltOfPass(shaders.Compose, pass)), Is.All.EqualTo(4));
        Assert.That(BuiltOfKernels(shaders.Progressive), Is.EqualTo(isProgressive ? 4 : 0));
        Assert.That(BuiltOfKernels(shaders.Raster), Is.EqualTo(4));
    }
}
