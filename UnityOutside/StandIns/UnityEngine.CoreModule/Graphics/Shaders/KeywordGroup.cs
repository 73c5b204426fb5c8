namespace StandIns.Graphics;

sealed class KeywordGroup
{
    internal readonly string[] Keywords; // The names; null for none.
    internal readonly bool IsLocal;
    readonly string m_stage;

    KeywordGroup(string[] keywords, bool isLocal, string stage) => (Keywords, IsLocal, m_stage) = (keywords, isLocal, stage);

    /// <summary>Reads a pragma's words; null if it declares no keywords.</summary>
    internal static KeywordGroup TryRead(string[] words)
    {
        string kind = words[0];
        string only = null;
        foreach (string stage in new[] { "_vertex", "_fragment" })
            if (kind.EndsWith(stage, StringComparison.Ordinal))
            {
                kind = kind[..^stage.Length];
                only = stage[1..5];
            }
        bool isLocal = kind.EndsWith("_local", StringComparison.Ordinal);
        if (isLocal)
            kind = kind[..^"_local".Length];
        if (kind != "multi_compile" && kind != "shader_feature")
            return null;
        var names = new List<string>();
        if (kind == "shader_feature" && words.Length == 2)
            names.Add(null);
        for (int i = 1; i < words.Length; i++)
            names.Add(words[i].Trim('_').Length == 0 ? null : words[i]);
        return new KeywordGroup(names.ToArray(), isLocal, only);
    }

    internal bool IsFor(string stage) => m_stage == null || m_stage == stage;

    internal int Choose(KeywordSet local, KeywordSet global)
    {
        for (int i = 0; i < Keywords.Length; i++)
            if (Keywords[i] != null && (local.Contains(Keywords[i]) || (!IsLocal && global.Contains(Keywords[i]))))
                return i;
        return Math.Max(0, Array.IndexOf(Keywords, null));
    }
}
