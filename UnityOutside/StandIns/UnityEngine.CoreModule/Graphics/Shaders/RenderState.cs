namespace StandIns.Graphics;

/// <summary>The fixed state of a pass: each value a word of ShaderLab's, or a property in square brackets, whose number is that
/// of Unity's enum (CullMode, CompareFunction, BlendMode, BlendOp).</summary>
sealed class RenderState
{
    static readonly string[] s_culls = { "Off", "Front", "Back" };
    static readonly string[] s_switches = { "Off", "On" };
    static readonly string[] s_tests =
    {
        "Off", "Never", "Less", "Equal", "LEqual", "Greater", "NotEqual", "GEqual", "Always",
    };
    static readonly string[] s_factors =
    {
        "Zero", "One", "DstColor", "SrcColor", "OneMinusDstColor", "SrcAlpha", "OneMinusSrcColor", "DstAlpha",
            "OneMinusDstAlpha",
        "SrcAlphaSaturate", "OneMinusSrcAlpha",
    };
    static readonly string[] s_operations = { "Add", "Sub", "RevSub", "Min", "Max" };

    StateValue m_cull = StateValue.Of(2);
    StateValue m_zTest = StateValue.Of(4);
    StateValue m_zWrite = StateValue.Of(1);
    StateValue m_sourceColor = StateValue.Of(1);
    StateValue m_targetColor = StateValue.Of(0);
    StateValue m_sourceAlpha = StateValue.Of(1);
    StateValue m_targetAlpha = StateValue.Of(0);
    StateValue m_colorOperation = StateValue.Of(0);
    StateValue m_alphaOperation = StateValue.Of(0);
    int m_colorMask = 15;

    internal RenderState() { }

    internal RenderState(RenderState other)
    {
        m_cull = other.m_cull;
        m_zTest = other.m_zTest;
        m_zWrite = other.m_zWrite;
        m_sourceColor = other.m_sourceColor;
        m_targetColor = other.m_targetColor;
        m_sourceAlpha = other.m_sourceAlpha;
        m_targetAlpha = other.m_targetAlpha;
        m_colorOperation = other.m_colorOperation;
        m_alphaOperation = other.m_alphaOperation;
        m_colorMask = other.m_colorMask;
    }

    internal bool TryRead(string word, ShaderLabTokens tokens)
    {
        switch (word.ToLowerInvariant())
        {
            case "cull":
                m_cull = StateValue.Read(tokens, s_culls);
                return true;
            case "ztest":
                m_zTest = StateValue.Read(tokens, s_tests);
                return true;
            case "zwrite":
                m_zWrite = StateValue.Read(tokens, s_switches);
                return true;
            case "zclip":
                tokens.Expect("True");
                return true;
            case "blend":
                ReadBlend(tokens);
                return true;
            case "blendop":
                m_colorOperation = m_alphaOperation = StateValue.Read(tokens, s_operations);
                if (tokens.TryTake(","))
                    m_alphaOperation = StateValue.Read(tokens, s_operations);
                return true;
            case "colormask":
                ReadColorMask(tokens);
                return true;
            default:
                return false;
        }
    }

    internal FixedState Evaluate(in PropertyScope scope) => new FixedState
    {
        Cull = (CullModeFlags)m_cull.Evaluate(scope),
        DepthTest = m_zTest.Evaluate(scope) is var test && test == 0 ? CompareOp.Always : Reversed(test),
        WritesDepth = m_zWrite.Evaluate(scope) != 0 && m_zTest.Evaluate(scope) != 0,
        SourceColor = Factor(m_sourceColor.Evaluate(scope)),
        TargetColor = Factor(m_targetColor.Evaluate(scope)),
        SourceAlpha = Factor(m_sourceAlpha.Evaluate(scope)),
        TargetAlpha = Factor(m_targetAlpha.Evaluate(scope)),
        ColorOperation = (BlendOp)m_colorOperation.Evaluate(scope),
        AlphaOperation = (BlendOp)m_alphaOperation.Evaluate(scope),
        ColorMask = (byte)m_colorMask,
    };

    // Near is 1 here and far 0: what is less far is greater.
    static CompareOp Reversed(int test) => test switch
    {
        1 => CompareOp.Never,
        2 => CompareOp.Greater,
        3 => CompareOp.Equal,
        4 => CompareOp.GreaterOrEqual,
        5 => CompareOp.Less,
        6 => CompareOp.NotEqual,
        7 => CompareOp.LessOrEqual,
        _ => CompareOp.Always,
    };

    static BlendFactor Factor(int factor) => factor switch
    {
        0 => BlendFactor.Zero,
        1 => BlendFactor.One,
        2 => BlendFactor.DstColor,
        3 => BlendFactor.SrcColor,
        4 => BlendFactor.OneMinusDstColor,
        5 => BlendFactor.SrcAlpha,
        6 => BlendFactor.OneMinusSrcColor,
        7 => BlendFactor.DstAlpha,
        8 => BlendFactor.OneMinusDstAlpha,
        9 => BlendFactor.SrcAlphaSaturate,
        _ => BlendFactor.OneMinusSrcAlpha,
    };

    void ReadBlend(ShaderLabTokens tokens)
    {
        if (int.TryParse(tokens.Next, NumberStyles.Integer, CultureInfo.InvariantCulture, out _))
            throw tokens.Error("Blend for one target of several is not supported");
        if (tokens.TryTake("Off"))
        {
            m_sourceColor = m_sourceAlpha = StateValue.Of(1);
            m_targetColor = m_targetAlpha = StateValue.Of(0);
            return;
        }
        m_sourceColor = m_sourceAlpha = StateValue.Read(tokens, s_factors);
        m_targetColor = m_targetAlpha = StateValue.Read(tokens, s_factors);
        if (!tokens.TryTake(","))
            return;
        m_sourceAlpha = StateValue.Read(tokens, s_factors);
        m_targetAlpha = StateValue.Read(tokens, s_factors);
    }

    void ReadColorMask(ShaderLabTokens tokens)
    {
        string mask = tokens.Take();
        m_colorMask = 0;
        foreach (char c in mask)
        {
            int bit = "RGBA".IndexOf(char.ToUpperInvariant(c));
            if (bit < 0 && c != '0')
                throw tokens.Error($"ColorMask {mask}");
            m_colorMask |= bit < 0 ? 0 : 1 << bit;
        }
    }
}
