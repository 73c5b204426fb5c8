using FastPoints.HostTests.Manual;
using Silk.NET.Vulkan;

namespace FastPoints.HostTests.Shaders;

[Category("Cross")]
public sealed class CrossTests
{
    const string Stereo = "FASTPOINTS_STEREO";

    // Nine buffers are more than WebGPU promises; doubles are in none of the languages.
    const string NineBuffers = "#pragma kernel Nine\nRWByteAddressBuffer _A, _B, _C, _D, _E, _F, _G, _H, _I;\n"
        + "[numthreads(1, 1, 1)] void Nine() { _A.Store(0u, _B.Load(0u) + _C.Load(0u) + _D.Load(0u) + _E.Load(0u)\n"
        + "+ _F.Load(0u) + _G.Load(0u) + _H.Load(0u) + _I.Load(0u)); }\n";
    const string Doubles = "#pragma kernel Wide\nRWByteAddressBuffer _A;\nfloat4 _V;\n"
        + "[numthreads(1, 1, 1)] void Wide() { double d = double(_V.x) * double(_V.y); _A.Store(0u, uint(d * d)); }\n";

    ScratchFolder m_folder;
    List<(ShaderStage Stage, string Metal, string Gles, string WebGpu)> m_all, m_planted;

    [OneTimeSetUp]
    public void CompileAll()
    {
        if (CrossCompilers.Missing.Length > 0)
            Assert.Ignore("not installed: " + CrossCompilers.Missing + " (with root: ./test --cross)");
        m_folder = new ScratchFolder();
        File.WriteAllText(m_folder["nine.compute"], NineBuffers);
        File.WriteAllText(m_folder["doubles.compute"], Doubles);
        string[] planted = { m_folder["nine.compute"], m_folder["doubles.compute"] };
        var stages = ShaderSources.In("Packages/com.fastpoints.dots").Select(s => Path.Combine(Checkout.Repository.Root, s))
            .Concat(planted).SelectMany(ShaderSources.StagesOf).ToList();
        var all = stages.Zip(CrossCompilers.Faults(stages), (s, f) => (s, f.Metal, f.Gles, f.WebGpu)).ToList();
        m_planted = all.TakeLast(planted.Length).ToList();
        m_all = all.SkipLast(planted.Length).ToList();
        int metal = m_all.Count(a => a.Metal.Length == 0), gles = m_all.Count(a => a.Gles.Length == 0);
        TestContext.Progress.WriteLine($"{m_all.Count} stages and kernels: {metal} go to Metal, {gles} compile as ESSL 3.1, "
            + $"{m_all.Count(a => a.WebGpu == "")} for WebGPU");
    }

    [OneTimeTearDown]
    public void RemoveFolder() => m_folder?.Dispose();

    [Test]
    public void Metal_EveryVariant_IsTranslated()
    {
        Assert.That(m_all, Has.Count.EqualTo(2 * 122 + 14));
        Assert.That(m_all.Where(a => a.Metal.Length > 0).Select(a => $"{a.Stage}: {a.Metal}"), Is.Empty);
    }

    [Test]
    public void WebGpu_EveryVariantThatChoosesNoSlice_Compiles()
    {
        RequireWebGpu();
        var faults = m_all.Where(a => a.WebGpu.Length > 0 && !ChoosesSlice(a.Stage)).Select(a => $"{a.Stage}: {a.WebGpu}");
        Assert.That(faults, Is.Empty);
    }

    [Test]
    public void TableOfTheManual_Counts_MatchTheCompilers()
    {
        int columns = CrossCompilers.MissingForWebGpu.Length == 0 ? 7 : 6;
        string[] Lines(IEnumerable<string[]> rows) => rows.Select(r => $"| {string.Join(" | ", r.Take(columns))} |").ToArray();
        string[] rows = Lines(Rows());
        Assert.That(Lines(ManualPage.Of("internals/rendering.md").TableUnder("## Where the shaders go")), Is.EqualTo(rows),
            string.Join("\n", rows));
    }

    [Test]
    public void Faults_DoublesInShaders_AreFound()
    {
        Assert.That(m_planted[1].Metal, Does.Contain("double"));
        Assert.That(m_planted[1].Gles, Is.Not.Empty);
    }

    [Test]
    public void Faults_NineBuffers_ExceedTheWebGpuLimit()
    {
        RequireWebGpu();
        Assert.That(m_planted[0].WebGpu, Does.Contain("storage buffers (9)"));
    }

    static void RequireWebGpu()
    {
        if (CrossCompilers.MissingForWebGpu.Length > 0)
            Assert.Ignore("not installed: " + CrossCompilers.MissingForWebGpu + " (./test --cross)");
    }

    // A row for each pass's stage and each kernel; vertex shaders that choose a slice have their own.
    IEnumerable<string[]> Rows() => m_all.GroupBy(a => (a.Stage.Name, a.Stage.Entry, IsStereo: ChoosesSlice(a.Stage)))
        .Select(g =>
    {
        string stage = g.First().Stage.Stage;
        int[] buffers = g.Select(a => Buffers(a.Stage)).Distinct().OrderBy(b => b).ToArray();
        string gles = buffers[^1] > SureBuffers(stage) ? $"compiles; of the buffers {SureBuffers(stage)} are sure" : "yes";
        return new[]
        {
            NameOf(g.Key.Name, g.Key.Entry) + (g.Key.IsStereo ? $", `{Stereo}`" : ""), StageName(stage), $"{g.Count()}",
            buffers.Length == 1 ? $"{buffers[0]}" : $"{buffers[0]} to {buffers[^1]}",
            Cell(g.Select(a => a.Metal)), Cell(g.Select(a => a.Gles), gles), Cell(g.Select(a => a.WebGpu)),
        };
    });

    static bool ChoosesSlice(ShaderStage stage) => stage.Stage == "vert" && stage.Keywords.Contains(Stereo);

    static string NameOf(string name, string entry) =>
        name.EndsWith(".compute", StringComparison.Ordinal) ? $"`{entry}`" : name.Split("pass ")[1];

    static string StageName(string stage) => stage == "vert" ? "vertex" : stage == "frag" ? "fragment" : "compute";

    static string Cell(IEnumerable<string> faults, string good = "yes") =>
        string.Join("; ", faults.Select(f => string.IsNullOrEmpty(f) ? good : "no: " + Reason(f)).Distinct());

    // The name that a compiler stumbles over.
    static string Reason(string fault) =>
        Regex.Match(fault, @"'(\w+)' : ") is { Success: true } name ? $"`{name.Groups[1].Value}`" : fault.Split('\n')[0];

    // Storage buffers that each OpenGL ES 3.1 has, by its specification's table of implementation-dependent values.
    static int SureBuffers(string stage) => stage == "comp" ? 4 : 0;

    static int Buffers(ShaderStage stage) =>
        new SpirvModule(stage.Compile()).Resources().Count(r => r.Kind == DescriptorType.StorageBuffer);
}
