namespace StandIns.Graphics;

sealed class ShaderPass
{
    // Unity adds it to every shader that asks for it, where a headset is drawn for in one pass.
    const string Stereo = "STEREO_INSTANCING_ON";

    internal readonly ShaderLabSource Shader;
    internal readonly string Name;
    internal readonly Dictionary<string, string> Tags;
    internal readonly RenderState State;
    internal readonly KeywordGroup[] Keywords;
    readonly string m_program;
    readonly string m_vertex;
    readonly string m_fragment;
    readonly Dictionary<long, GraphicsProgram> m_programs = new Dictionary<long, GraphicsProgram>();

    internal ShaderPass(ShaderLabSource shader, string name, Dictionary<string, string> tags, RenderState state, string program)
    {
        Shader = shader;
        Name = name;
        Tags = tags;
        State = state;
        m_program = program;
        var keywords = new List<KeywordGroup>();
        foreach (string[] words in ShaderPragmas.Of(program))
        {
            if (words[0] == "vertex")
                m_vertex = words[1];
            else if (words[0] == "fragment")
                m_fragment = words[1];
            else if (KeywordGroup.TryRead(words) is { } group)
                keywords.Add(group);
        }
        if (m_vertex == null || m_fragment == null)
            throw new InvalidDataException($"{shader.Name}, pass {name}: a #pragma vertex and a #pragma fragment are wanted");
        if (Names(Stereo))
            keywords.Add(KeywordGroup.TryRead(new[] { "multi_compile", "_", Stereo }));
        Keywords = keywords.ToArray();
    }

    string Label => Name.Length == 0 ? Shader.Name : Shader.Name + ", pass " + Name;

    internal GraphicsProgram Program(KeywordSet local)
    {
        long variant = KeywordVariant.Choose(Keywords, local);
        if (!m_programs.TryGetValue(variant, out GraphicsProgram program))
            m_programs.Add(variant, program = Compile(variant));
        return program;
    }

    internal ShaderStage Vertex(long variant) => Stage(variant, "vert", m_vertex);
    internal ShaderStage Fragment(long variant) => Stage(variant, "frag", m_fragment);

    bool Names(string keyword) => m_program.Contains(keyword)
        || Shader.Files.Includes(m_program).Any(file => File.ReadAllText(file).Contains(keyword));

    ShaderStage Stage(long variant, string stage, string entry) =>
        new ShaderStage(Shader.Files, Label, m_program, stage, entry, KeywordVariant.Names(Keywords, variant, stage).ToArray());

    GraphicsProgram Compile(long variant)
    {
        GpuDevice device = GpuDevice.Current;
        return new GraphicsProgram(device, Label,
            SpirvModule.For(device, SpirvPointSize.Given(Vertex(variant).Compile())), m_vertex,
            SpirvModule.For(device, Fragment(variant).Compile()), m_fragment);
    }
}
