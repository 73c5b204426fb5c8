namespace StandIns.Graphics;

sealed class ShaderLabTokens
{
    readonly string m_path;
    readonly List<(string Text, int Line)> m_tokens = new List<(string, int)>();
    int m_at;

    internal ShaderLabTokens(string path, string text)
    {
        m_path = path;
        Split(text);
    }

    internal bool IsAtEnd => m_at == m_tokens.Count;
    internal string Next => IsAtEnd ? "" : m_tokens[m_at].Text; // The next word, not yet taken; empty at the end.

    internal int Line => m_tokens.Count == 0 ? 0 : m_tokens[Math.Max(0, m_at - 1)].Line;

    internal string Take()
    {
        if (IsAtEnd)
            throw Error("the file ends within a block");
        return m_tokens[m_at++].Text;
    }

    internal bool TryTake(string word)
    {
        if (!string.Equals(Next, word, StringComparison.OrdinalIgnoreCase))
            return false;
        m_at++;
        return true;
    }

    internal void Expect(string word)
    {
        if (!TryTake(word))
            throw Error($"'{word}' is wanted, '{Next}' is there");
    }

    internal string TakeText()
    {
        string token = Take();
        if (token.Length < 2 || token[0] != '"')
            throw Error($"a text in quotes is wanted, {token} is there");
        return token[1..^1];
    }

    internal InvalidDataException Error(string what) => new InvalidDataException($"{m_path}({Line}): {what}");

    void Split(string text)
    {
        int line = 1;
        for (int at = 0; at < text.Length;)
        {
            int end = End(text, at);
            string token = text[at..end];
            bool isBlank = char.IsWhiteSpace(token[0]) || token.StartsWith("//", StringComparison.Ordinal)
                || token.StartsWith("/*", StringComparison.Ordinal);
            if (!isBlank)
                m_tokens.Add((token, line));
            foreach (char c in token)
                line += c == '\n' ? 1 : 0;
            at = end;
        }
    }

    static int End(string text, int at)
    {
        char c = text[at];
        if (c == '"')
            return After(text, "\"", at + 1);
        if (string.CompareOrdinal(text, at, "//", 0, 2) == 0)
            return Math.Max(at + 2, After(text, "\n", at) - 1);
        if (string.CompareOrdinal(text, at, "/*", 0, 2) == 0)
            return After(text, "*/", at + 2);
        if (!IsPartOfWord(c))
            return at + 1;
        int end = at;
        while (end < text.Length && IsPartOfWord(text[end]))
            end++;
        return text[at..end] switch
        {
            "HLSLPROGRAM" or "HLSLINCLUDE" => After(text, "ENDHLSL", end),
            "CGPROGRAM" or "CGINCLUDE" => After(text, "ENDCG", end),
            _ => end,
        };
    }

    static int After(string text, string word, int from)
    {
        int found = text.IndexOf(word, from, StringComparison.Ordinal);
        return found < 0 ? text.Length : found + word.Length;
    }

    static bool IsPartOfWord(char c) => char.IsLetterOrDigit(c) || c == '_' || c == '.' || c == '-' || c == '+';
}
