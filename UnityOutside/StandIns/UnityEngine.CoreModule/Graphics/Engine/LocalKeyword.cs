namespace UnityEngine.Rendering;

public readonly struct LocalKeyword
{
    /// <exception cref="ArgumentException">The shader has no such keyword; Unity logs an error.</exception>
    public LocalKeyword(Shader shader, string name)
    {
        if (!shader.Source.Passes.Any(pass => pass.Keywords.Any(group => group.IsLocal && group.Keywords.Contains(name))))
            throw new ArgumentException($"{shader.name} has no local keyword {name}");
        this.name = name;
    }

    public string name { get; }
}

public struct ShaderKeywordSet
{
    readonly string[] m_names;

    internal ShaderKeywordSet(params string[] names) => m_names = names;

    public readonly bool IsEnabled(LocalKeyword keyword) => m_names != null && m_names.Contains(keyword.name);
}
