namespace UnityOutside.Hpc;

/// <summary>A processor that Burst compiles for, by the names of its properties "Is...Supported". As in Burst's own sources each
/// level of x86 has those below it, popcnt is SSE4.2's, and BMI, FMA and F16C are AVX2's.</summary>
internal sealed class HpcTarget
{
    private static readonly string[] s_ofX86 =
    {
        "Sse", "Sse2", "Sse3", "Ssse3", "Sse41", "Sse42", "Popcnt", "Avx", "Avx2", "Fma", "F16C", "Bmi1", "Bmi2",
    };

    // Neon's are methods of one class, whatever they need.
    private static readonly (string Start, string Feature)[] s_ofNeon =
    {
        ("vdot", "NeonDotProd"), ("vqrdml", "NeonRDMA"), ("vaes", "NeonCrypto"), ("vsha", "NeonCrypto"),
    };

    private static readonly string[] s_numbers = { "SHUFFLE", "SHUFFLE2" };

    private readonly HashSet<string> m_features;

    private HpcTarget(string name, IEnumerable<string> features) => (Name, m_features) = (name, features.ToHashSet());

    /// <summary>Those of x64 players, the last an editor's too, and Apple's and telephones'.</summary>
    internal static IReadOnlyList<HpcTarget> All { get; } = new[]
    {
        new HpcTarget("SSE2", s_ofX86.Take(2)), new HpcTarget("SSE4", s_ofX86.Take(7)), new HpcTarget("AVX", s_ofX86.Take(8)),
        new HpcTarget("AVX2", s_ofX86), new HpcTarget("ARM64", new[] { "Neon" }),
    };

    internal string Name { get; }

    internal bool Has(string feature) => m_features.Contains(feature);

    internal static string? Asked(MethodReference getter) =>
        IsIntrinsic(getter.DeclaringType) && getter.Name.StartsWith("get_Is", StringComparison.Ordinal)
            && getter.Name.EndsWith("Supported", StringComparison.Ordinal) ? getter.Name[6..^9] : null;

    /// <summary>The feature without which Burst refuses a call; null if it takes it for any processor.</summary>
    internal static string? Needed(MethodReference called)
    {
        if (!IsIntrinsic(called.DeclaringType) || Asked(called) != null || s_numbers.Contains(called.Name))
            return null;
        if (called.DeclaringType.Name != "Neon")
            return called.DeclaringType.Name.Replace("_", "", StringComparison.Ordinal);
        return called.Name.Contains("_f16", StringComparison.Ordinal) ? "NeonHalfFP"
            : s_ofNeon.FirstOrDefault(n => called.Name.StartsWith(n.Start, StringComparison.Ordinal)).Feature ?? "Neon";
    }

    private static bool IsIntrinsic(TypeReference type) =>
        type.DeclaringType?.FullName is "Unity.Burst.Intrinsics.X86" or "Unity.Burst.Intrinsics.Arm";
}
