namespace StandIns.Graphics;

/// <summary>The part of ShaderLab that thin wrappers of HLSL use: Properties, the first SubShader, its passes with their tags,
/// fixed state and programs. What it does not know it refuses, rather than to draw something else.</summary>
sealed class ShaderLabReader
{
    readonly ShaderLabTokens m_tokens;
    ShaderLabSource m_shader;

    ShaderLabReader(string path) => m_tokens = new ShaderLabTokens(path, File.ReadAllText(path));

    internal static ShaderLabSource Read(string path) => new ShaderLabReader(path).ReadShader(new ShaderFiles(path));

    ShaderLabSource ReadShader(ShaderFiles files)
    {
        m_tokens.Expect("Shader");
        m_shader = new ShaderLabSource(m_tokens.TakeText(), files);
        m_tokens.Expect("{");
        var common = new StringBuilder();
        while (!m_tokens.TryTake("}"))
        {
            string word = m_tokens.Take();
            if (IsWord(word, "Properties"))
                ReadProperties();
            else if (IsInclude(word))
                Append(common, word);
            else if (IsWord(word, "SubShader"))
                ReadSubShader(common.ToString(), isWanted: m_shader.Passes.Count == 0);
            else if (IsWord(word, "Fallback") || IsWord(word, "CustomEditor"))
                m_tokens.Take();
            else
                throw m_tokens.Error($"'{word}' is not known in a Shader");
        }
        if (m_shader.Passes.Count == 0)
            throw m_tokens.Error("no SubShader with a Pass");
        return m_shader;
    }

    void ReadProperties()
    {
        m_tokens.Expect("{");
        while (!m_tokens.TryTake("}"))
        {
            while (m_tokens.TryTake("["))
                SkipTo("]");
            int name = PropertyNames.IdOf(m_tokens.Take());
            m_tokens.Expect("(");
            m_tokens.TakeText();
            m_tokens.Expect(",");
            string type = m_tokens.Take();
            if (m_tokens.TryTake("("))
                SkipTo(")");
            m_tokens.Expect(")");
            m_tokens.Expect("=");
            ReadDefault(name, type);
        }
    }

    void ReadDefault(int name, string type)
    {
        if (IsWord(type, "Float") || IsWord(type, "Range") || IsWord(type, "Int"))
            m_shader.Defaults.Set(name, PropertyValue.Of(Number()));
        else if (IsWord(type, "Integer"))
            m_shader.Defaults.Set(name, PropertyValue.Of((int)Number()));
        else if (IsWord(type, "Color") || IsWord(type, "Vector"))
            m_shader.Defaults.Set(name, PropertyValue.Of(FourNumbers()));
        else
        {
            // A texture: what it is called where none is set is not drawn here.
            m_tokens.TakeText();
            m_tokens.Expect("{");
            m_tokens.Expect("}");
        }
    }

    void ReadSubShader(string common, bool isWanted)
    {
        var state = new RenderState();
        var shared = new StringBuilder(common);
        m_tokens.Expect("{");
        while (!m_tokens.TryTake("}"))
        {
            string word = m_tokens.Take();
            if (IsWord(word, "PackageRequirements"))
                isWanted &= !ReadRequirements();
            else if (IsWord(word, "Tags"))
                ReadTags();
            else if (IsWord(word, "LOD"))
                Number();
            else if (IsInclude(word))
                Append(shared, word);
            else if (IsWord(word, "Pass"))
                ReadPass(shared.ToString(), new RenderState(state), isWanted);
            else if (!state.TryRead(word, m_tokens))
                throw m_tokens.Error($"'{word}' is not known in a SubShader");
        }
    }

    void ReadPass(string shared, RenderState state, bool isWanted)
    {
        string name = "";
        StringBuilder program = null;
        Dictionary<string, string> tags = null;
        m_tokens.Expect("{");
        while (!m_tokens.TryTake("}"))
        {
            string word = m_tokens.Take();
            if (IsWord(word, "Name"))
                name = m_tokens.TakeText();
            else if (IsWord(word, "Tags"))
                tags = ReadTags();
            else if (IsWord(word, "LOD"))
                Number();
            else if (word.StartsWith("HLSLPROGRAM", StringComparison.Ordinal)
                || word.StartsWith("CGPROGRAM", StringComparison.Ordinal))
                Append(program = new StringBuilder(shared), word);
            else if (!state.TryRead(word, m_tokens))
                throw m_tokens.Error($"'{word}' is not known in a Pass");
        }
        if (program == null)
            throw m_tokens.Error("a Pass without a program");
        if (isWanted)
            m_shader.Passes.Add(new ShaderPass(m_shader, name, tags
                ?? new Dictionary<string, string>(), state, program.ToString()));
    }

    // Of packages, none of which has shaders here. Returns whether there are any.
    bool ReadRequirements()
    {
        m_tokens.Expect("{");
        bool isAny = false;
        for (; !m_tokens.TryTake("}"); isAny = true)
            m_tokens.TakeText();
        return isAny;
    }

    Dictionary<string, string> ReadTags()
    {
        var tags = new Dictionary<string, string>();
        m_tokens.Expect("{");
        while (!m_tokens.TryTake("}"))
        {
            string key = m_tokens.TakeText();
            m_tokens.Expect("=");
            tags[key] = m_tokens.TakeText();
        }
        return tags;
    }

    // A line directive, so that the compiler's messages name the lines of the .shader file.
    void Append(StringBuilder text, string block)
    {
        int start = block.IndexOf("PROGRAM", StringComparison.Ordinal);
        start = start >= 0 && start < 5 ? start + "PROGRAM".Length
            : block.IndexOf("INCLUDE", StringComparison.Ordinal) + "INCLUDE".Length;
        int end = Math.Max(block.LastIndexOf("ENDHLSL", StringComparison.Ordinal),
            block.LastIndexOf("ENDCG", StringComparison.Ordinal));
        if (end < start)
            throw m_tokens.Error("a program that does not end");
        text.Append("#line ").Append(m_tokens.Line).Append('\n').Append(block, start, end - start).Append('\n');
    }

    Vector4 FourNumbers()
    {
        Vector4 numbers = default;
        m_tokens.Expect("(");
        for (int i = 0; i < 4; i++)
        {
            if (i > 0)
                m_tokens.Expect(",");
            numbers[i] = Number();
        }
        m_tokens.Expect(")");
        return numbers;
    }

    float Number() => float.TryParse(m_tokens.Take(), NumberStyles.Float, CultureInfo.InvariantCulture, out float number)
        ? number : throw m_tokens.Error("a number is wanted");

    void SkipTo(string word)
    {
        while (m_tokens.Take() != word)
        {
        }
    }

    static bool IsInclude(string word) => word.StartsWith("HLSLINCLUDE", StringComparison.Ordinal)
        || word.StartsWith("CGINCLUDE", StringComparison.Ordinal);

    static bool IsWord(string word, string known) => string.Equals(word, known, StringComparison.OrdinalIgnoreCase);
}
