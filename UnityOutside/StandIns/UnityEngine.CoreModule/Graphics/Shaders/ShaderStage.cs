namespace StandIns.Graphics;

sealed class ShaderStage(ShaderFiles files, string name, string source, string stage, string entry, string[] keywords)
{
    internal readonly ShaderFiles Files = files;
    internal readonly string Name = name;
    internal readonly string Source = source;
    internal readonly string Stage = stage;
    internal readonly string Entry = entry;
    internal readonly string[] Keywords = keywords;

    internal byte[] Compile() => ShaderCompiler.Compile(Files, Name, Source, Stage, Entry, Keywords);

    public override string ToString() => string.Join(" ", new[] { Name, Entry }.Concat(Keywords));
}
