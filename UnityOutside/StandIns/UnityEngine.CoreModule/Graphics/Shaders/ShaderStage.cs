namespace StandIns.Graphics;

/// <summary>One stage of one variant of a shader, or a kernel: what a compiler is given.</summary>
sealed class ShaderStage(ShaderFiles files, string name, string source, string stage, string entry, string[] keywords)
{
    internal readonly ShaderFiles Files = files;
    /// <summary>The shader and its pass, or the compute file: how messages name it.</summary>
    internal readonly string Name = name;
    /// <summary>HLSL with its pragmas, without what it includes.</summary>
    internal readonly string Source = source;
    /// <summary>As glslang calls it: vert, frag, comp.</summary>
    internal readonly string Stage = stage;
    internal readonly string Entry = entry;
    internal readonly string[] Keywords = keywords;

    /// <summary>SPIR-V, made without a device.</summary>
    /// <exception cref="System.InvalidOperationException">It does not compile.</exception>
    internal byte[] Compile() => ShaderCompiler.Compile(Files, Name, Source, Stage, Entry, Keywords);

    public override string ToString() => string.Join(" ", new[] { Name, Entry }.Concat(Keywords));
}
