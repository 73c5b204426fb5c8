using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace UnityOutside.Tests.Hpc;

[TestFixture(OptimizationLevel.Debug)]
[TestFixture(OptimizationLevel.Release)]
public sealed class HpcIntrinsicsTests(OptimizationLevel level)
{
    private static readonly string s_planted =
        File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "Hpc", "PlantedIntrinsics.txt"));

    [TestCase("if (Avx2.IsAvx2Supported) sum = Avx2.add(count, 1);")]
    [TestCase("if (Avx2.IsAvx2Supported) for (; count > 0; count--) sum = Avx2.add(sum, count);")]
    [TestCase("if (Avx2.IsAvx2Supported && count >= 8) sum = Avx2.add(count, 1); else sum = count;")]
    [TestCase("if (count > 8 && Avx2.IsAvx2Supported && count < 99) sum = Avx2.add(count, 1);")]
    [TestCase("bool isFast = Avx2.IsAvx2Supported; if (isFast) sum = Avx2.add(count, 1);")]
    [TestCase("if (Avx2.IsAvx2Supported) sum = Guarded(count);")]
    [TestCase("if (Avx2.IsAvx2Supported) sum = Avx.add(Sse4_1.add(Fma.add(count, 1), Bmi2.add(2, 3)), Popcnt.popcnt(4));")]
    [TestCase("if (Avx2.IsAvx2Supported) sum = Avx2.add(0, 1); else if (Neon.IsNeonSupported) sum = Neon.vadd_s32(0, 1);")]
    [TestCase("if (Neon.IsNeonDotProdSupported) sum = Neon.vdot_s32(0, 1);")]
    [TestCase("sum = Sse.SHUFFLE(0, 1);")]
    public void Verify_AskedInTheSameMethod_Passes(string code) => Assert.That(Problems(code), Is.Empty);

    [TestCase("sum = Avx2.add(0, 1);", "SSE2, SSE4, AVX, ARM64")]
    [TestCase("if (Avx2.IsAvx2Supported) sum = 1; sum += Avx2.add(0, 1);", "SSE2, SSE4, AVX, ARM64")]
    [TestCase("if (Avx2.IsAvx2Supported) sum = 1; else sum = Avx2.add(0, 1);", "SSE2, SSE4, AVX, ARM64")]
    [TestCase("if (Avx2.IsAvx2Supported) sum = Unguarded(count);", "SSE2, SSE4, AVX, ARM64")]
    [TestCase("if (Avx2.IsAvx2Supported) sum = Add(0); static int Add(int a) => Avx2.add(a, 1);", "SSE2, SSE4, AVX, ARM64")]
    [TestCase("if (IsFast) sum = Avx2.add(0, 1);", "SSE2, SSE4, AVX, ARM64")]
    [TestCase("bool isFast = Avx2.IsAvx2Supported; if (count > 3) isFast = true; if (isFast) sum = Avx2.add(0, 1);",
        "SSE2, SSE4, AVX, ARM64")]
    [TestCase("bool isFast = Avx2.IsAvx2Supported; Change(ref isFast); if (isFast) sum = Avx2.add(0, 1);",
        "SSE2, SSE4, AVX, ARM64")]
    [TestCase("if (Avx2.IsAvx2Supported || count > 8) sum = Avx2.add(0, 1);", "SSE2, SSE4, AVX, ARM64")]
    [TestCase("if (Avx.IsAvxSupported) sum = Avx2.add(0, 1);", "AVX")]
    [TestCase("if (Sse4_1.IsSse41Supported) sum = Bmi2.add(0, 1);", "SSE4, AVX")]
    [TestCase("sum = Popcnt.popcnt(0);", "SSE2, ARM64")]
    [TestCase("sum = Sse2.add(0, 1);", "ARM64")]
    [TestCase("sum = Neon.vadd_s32(0, 1);", "SSE2, SSE4, AVX, AVX2")]
    [TestCase("if (Neon.IsNeonSupported) sum = Neon.vdot_s32(0, 1);", "ARM64")]
    public void Verify_NotAskedInTheSameMethod_IsRefusedForThoseProcessors(string code, string processors) =>
        Assert.That(Problems(code), Has.Some.Match(@"has not found Is\w+Supported to be true \(for " + processors + @"\)$"));

    [TestCase("if (!Avx2.IsAvx2Supported) return 0; sum = Avx2.add(0, 1);")]
    [TestCase("if (!Avx2.IsAvx2Supported) sum = 1; else sum = Avx2.add(0, 1);")]
    [TestCase("if (!Avx2.IsAvx2Supported && count > 8) return 1;")]
    [TestCase("sum = Avx2.IsAvx2Supported ? Avx2.add(0, 1) : 2;")]
    [TestCase("if (Avx2.IsAvx2Supported || count > 8) sum = 1;")]
    public void Verify_AskedForTheOpposite_IsRefused(string code) =>
        Assert.That(Problems(code), Has.Some.Contains("jumps away where IsAvx2Supported is true"));

    [Test]
    public void Verify_UnguardedHelper_IsNamedWithTheCallThatLedToIt() => Assert.That(
        Problems("if (Avx2.IsAvx2Supported) sum = Unguarded(count);"), Has.One.Items.And.Some.StartsWith(
            "Planted.Run: Planted.Run > Planted.Unguarded (IL_"));

    private IReadOnlyCollection<string> Problems(string code)
    {
        var tree = CSharpSyntaxTree.ParseText(s_planted.Replace("//CODE", code, StringComparison.Ordinal));
        var references = new[] { typeof(object), typeof(BurstCompileAttribute) }
            .Select(t => MetadataReference.CreateFromFile(t.Assembly.Location))
            .Append(MetadataReference.CreateFromFile(System.Reflection.Assembly.Load("System.Runtime").Location));
        var options = new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, optimizationLevel: level);
        using var image = new MemoryStream();
        var result = CSharpCompilation.Create("Planted", new[] { tree }, references, options).Emit(image);
        Assert.That(result.Success, Is.True, string.Join("\n", result.Diagnostics));
        image.Position = 0;
        using var module = ModuleDefinition.ReadModule(image);
        return new HpcVerifier(new[] { module }).Verify(_ => true);
    }
}
