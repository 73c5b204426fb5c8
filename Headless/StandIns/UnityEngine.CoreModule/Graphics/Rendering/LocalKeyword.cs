namespace UnityEngine.Rendering;

public readonly struct LocalKeyword
{
    internal LocalKeyword(string name) => this.name = name;

    public string name { get; }
}

/// <summary>Those that a shader's passes declare.</summary>
public readonly struct LocalKeywordSpace
{
    readonly ShaderLabSource m_source;

    internal LocalKeywordSpace(ShaderLabSource source) => m_source = source;

    public LocalKeyword[] keywords => m_source.Passes.SelectMany(p => p.Keywords).SelectMany(g => g.Keywords)
        .Where(k => k != null).Distinct().Select(k => new LocalKeyword(k)).ToArray();
}

/// <summary>Those of a variant.</summary>
public struct ShaderKeywordSet
{
    internal HashSet<string> Names;

    public bool IsEnabled(LocalKeyword keyword) => Names.Contains(keyword.name);
}
