namespace StandIns.Graphics;

/// <summary>The pragmas in a shader's own text (Unity does not look for them in includes either).</summary>
static class ShaderPragmas
{
    internal static IEnumerable<string[]> Of(string text)
    {
        foreach (string line in text.Split('\n'))
        {
            string code = line.Split(new[] { "//" }, StringSplitOptions.None)[0].Trim();
            if (!code.StartsWith("#", StringComparison.Ordinal))
                continue;
            string[] words = code[1..].Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length > 1 && words[0] == "pragma")
                yield return words[1..];
        }
    }
}
