namespace FastPoints.HostTests.Shaders;

static class ShaderSources
{
    internal static IEnumerable<string> In(string folder) => Checkout.Files().Where(f =>
        f.StartsWith(folder + "/", StringComparison.Ordinal)
        && (f.EndsWith(".shader", StringComparison.Ordinal) || f.EndsWith(".compute", StringComparison.Ordinal)));

    internal static IEnumerable<ShaderStage> StagesOf(string path)
    {
        if (path.EndsWith(".compute", StringComparison.Ordinal))
        {
            var source = new ComputeSource(path);
            return source.Kernels.SelectMany(kernel => Variants(source.Keywords).Select(v => source.Kernel(kernel, v)));
        }
        return ShaderLabReader.Read(path).Passes
            .SelectMany(pass => Variants(pass.Keywords).SelectMany(v => new[] { pass.Vertex(v), pass.Fragment(v) }));
    }

    static IEnumerable<long> Variants(KeywordGroup[] groups)
    {
        for (long variant = 0; variant < KeywordVariant.Count(groups); variant++)
            yield return variant;
    }
}
