using System.ComponentModel;

namespace FastPoints.HostTests.Shaders;

public sealed class ShaderVariantTests
{
    private const long MaxVariants = 256; // More would take minutes: then keywords want to become uniforms.

    private static IEnumerable<string> Shaders() => ShaderSources.In("Packages").Concat(ShaderSources.In("UnityOutside/Tests"));

    [TestCaseSource(nameof(Shaders))]
    public void Variants_OfAShader_AreValid(string shader)
    {
        if (!ShaderCompiler.IsThere)
            Assert.Ignore("glslangValidator is not installed (Debian, Ubuntu: apt-get install glslang-tools)");
        if (!HasChecker())
            Assert.Ignore("spirv-val is not installed (Debian, Ubuntu: apt-get install spirv-tools)");
        using var folder = new ScratchFolder();
        ShaderStage[] all = ShaderSources.StagesOf(Path.Combine(Checkout.Repository.Root, shader)).ToArray();
        Assert.That(all.Length, Is.LessThanOrEqualTo(MaxVariants));
        var faults = new string[all.Length];
        Parallel.For(0, all.Length, Tool.OneACore, i =>
        {
            File.WriteAllBytes(folder[i + ".spv"], all[i].Compile());
            faults[i] = Check(folder[i + ".spv"]);
        });
        Assert.That(faults.Where(f => f.Length > 0), Is.Empty);
    }

    [Test]
    public void Conditions_OfThePackagesShaders_UseItsOwnNamesOnly()
    {
        string folder = Path.Combine(Checkout.Repository.PackageRoot, "Shaders");
        var names = Directory.GetFiles(folder, "*", SearchOption.AllDirectories).SelectMany(File.ReadLines)
            .Where(l => Regex.IsMatch(l, @"^\s*#\s*(el)?if"))
            .SelectMany(l => Regex.Matches(l, @"[A-Za-z_]\w+").Select(m => m.Value))
            .Where(n => n is not ("if" or "ifdef" or "ifndef" or "elif" or "defined")).Distinct().ToList();
        Assert.That(names, Is.Not.Empty.And.All.StartsWith("FASTPOINTS_"));
    }

    /// <summary>No material of a project names them, so Unity would strip features.</summary>
    [Test]
    public void Keywords_OfThePackagesShaders_GoIntoEveryPlayer()
    {
        string folder = Path.Combine(Checkout.Repository.PackageRoot, "Shaders");
        var pragmas = Directory.GetFiles(folder, "*", SearchOption.AllDirectories).SelectMany(File.ReadLines)
            .Select(l => Regex.Match(l, @"#\s*pragma\s+(multi_compile|shader_feature)\w*").Groups[1].Value)
            .Where(p => p.Length > 0).ToList();
        Assert.That(pragmas, Is.Not.Empty.And.All.EqualTo("multi_compile"));
    }

    private static bool HasChecker()
    {
        try
        {
            using Process process = Start("--version");
            process.WaitForExit();
            return true;
        }
        catch (Win32Exception)
        {
            return false;
        }
    }

    private static string Check(string file)
    {
        using Process process = Start($"--relax-block-layout --target-env vulkan1.1 \"{file}\"");
        string said = process.StandardError.ReadToEnd();
        process.WaitForExit();
        return process.ExitCode == 0 ? "" : said;
    }

    private static Process Start(string arguments) => Process.Start(new ProcessStartInfo("spirv-val", arguments)
    {
        RedirectStandardOutput = true,
        RedirectStandardError = true,
    });
}
