namespace FastPoints.HostTests.Shaders;

/// <summary>Every variant of every shader of the package through Direct3D's compiler: ./test --d3d.</summary>
[Category("Direct3D")]
public sealed class Direct3DTests
{
    // D3DCOMPILE_OPTIMIZATION_LEVEL3; the same and ENABLE_STRICTNESS; DEBUG and SKIP_OPTIMIZATION, which
    // #pragma enable_d3d11_debug_symbols asks for, and which warns of more.
    static readonly uint[] s_flags = { 0x8000, 0x8800, 0x5 };

    const string EarlyReturn = "#pragma kernel Early\nRWByteAddressBuffer _Out;\nuint _Number;\nfloat3 Chosen(uint number)\n"
        + "{ if (number != 0u) { float3 a = float3(_Out.Load(4u), 1.0, 2.0); return a; } return _Out.Load(8u).xxx; }\n"
        + "[numthreads(1, 1, 1)] void Early() { _Out.Store(0u, uint(Chosen(_Number).x)); }\n";
    const string NoSuchName = "#pragma kernel Wrong\n[numthreads(1, 1, 1)] void Wrong() { _Nothing.Store(0u, 1u); }\n";

    ScratchFolder m_folder;
    ILookup<string, string> m_saidOf;
    int m_stages;

    static IEnumerable<string> Shaders() => ShaderSources.In("Packages/com.fastpoints.dots");

    [OneTimeSetUp]
    public void CompileAll()
    {
        if (Direct3DCompiler.Missing.Length > 0)
            Assert.Ignore("not installed: " + Direct3DCompiler.Missing + " (with root: ./test --d3d)");
        m_folder = new ScratchFolder();
        File.WriteAllText(m_folder["early.compute"], EarlyReturn);
        File.WriteAllText(m_folder["wrong.compute"], NoSuchName);
        var all = Shaders().Select(s => (Shader: s, Path: Path.Combine(Checkout.Repository.Root, s)))
            .Concat(new[] { "early.compute", "wrong.compute" }.Select(s => (Shader: s, Path: m_folder[s])))
            .SelectMany(s => ShaderSources.StagesOf(s.Path).Select(stage => (s.Shader, Stage: stage)))
            .SelectMany(s => s_flags.Select(flags => (s.Shader, s.Stage, Flags: flags))).ToList();
        string[] said = Direct3DCompiler.Compile(all.Select(a => (a.Stage, a.Flags)).ToList());
        m_stages = all.Count(a => Shaders().Contains(a.Shader)) / s_flags.Length;
        m_saidOf = all.Zip(said, (a, s) => (a.Shader, Said: s.Length == 0 ? "" : $"{a.Stage} (flags {a.Flags:x}): {s}"))
            .ToLookup(a => a.Shader, a => a.Said);
    }

    [OneTimeTearDown]
    public void RemoveFolder() => m_folder?.Dispose();

    [TestCaseSource(nameof(Shaders))]
    public void Variants_OfAShader_CompileWithoutAWarning(string shader)
    {
        Assert.That(m_saidOf[shader], Is.Not.Empty);
        Assert.That(m_saidOf[shader].Where(s => s.Length > 0), Is.Empty);
    }

    [Test]
    public void Variants_OfAll_AreThoseThatUnityBuilds()
    {
        TestContext.Progress.WriteLine($"{m_stages} stages and kernels, each compiled in {s_flags.Length} ways");
        Assert.That(m_stages, Is.EqualTo(2 * 122 + 14));
    }

    [Test]
    public void Compile_EarlyReturn_IsWarnedOf() => Assert.That(m_saidOf["early.compute"], Has.Some.Matches(
        "early.compute\\(5,\\d+\\): warning X4000: use of potentially uninitialized variable \\(Chosen\\)"));

    [Test]
    public void Compile_Error_NamesTheFileAndItsLine() => Assert.That(m_saidOf["wrong.compute"],
        Has.All.Matches("failed\nwrong.compute\\(2,\\d+-\\d+\\): error X3004: undeclared identifier '_Nothing'"));
}
