namespace StandIns.Graphics;

/// <summary>The size of points: Vulkan wants a vertex shader to give it, and glslang does not know HLSL's PSIZE. Its output of
/// that semantic becomes the size; if there is none, the size is one pixel, as with Direct3D.</summary>
static class SpirvPointSize
{
    const string Names = "SPV_GOOGLE_hlsl_functionality1";
    const int HeaderWords = 5;
    const int BoundWord = 3;
    const uint OpExtension = 10;
    const uint OpEntryPoint = 15;
    const uint OpTypeFloat = 22;
    const uint OpTypePointer = 32;
    const uint OpConstant = 43;
    const uint OpFunction = 54;
    const uint OpVariable = 59;
    const uint OpStore = 62;
    const uint OpDecorate = 71;
    const uint OpLabel = 248;
    const uint OpDecorateString = 5632;
    const uint Output = 3;
    const uint Location = 30;
    const uint BuiltIn = 11;
    const uint PointSize = 1;

    internal static byte[] Given(byte[] code)
    {
        var words = new uint[code.Length / 4];
        Buffer.BlockCopy(code, 0, words, 0, code.Length);
        uint size = Named(words);
        uint[] changed = size != 0 ? WithoutNames(words, size, null) : WithoutNames(words, 0, new OnePixel(words));
        var bytes = new byte[changed.Length * 4];
        Buffer.BlockCopy(changed, 0, bytes, 0, bytes.Length);
        return bytes;
    }

    // The output with the semantic, or that is the size already; 0 if there is none.
    static uint Named(uint[] words)
    {
        for (int at = HeaderWords; at < words.Length; at += Length(words, at))
            if (Op(words, at) == OpDecorate && words[at + 2] == BuiltIn && words[at + 3] == PointSize)
                return words[at + 1];
            else if (Op(words, at) == OpDecorateString && Text(words, at, 3).Equals("PSIZE", StringComparison.OrdinalIgnoreCase))
                return words[at + 1];
        return 0;
    }

    static string Text(uint[] words, int at, int first)
    {
        var text = new byte[(Length(words, at) - first) * 4];
        Buffer.BlockCopy(words, (at + first) * 4, text, 0, text.Length);
        return Encoding.ASCII.GetString(text).TrimEnd('\0');
    }

    static uint[] WithoutNames(uint[] words, uint size, OnePixel added)
    {
        var changed = new List<uint>(words.Length + 32);
        for (int i = 0; i < HeaderWords; i++)
            changed.Add(words[i]);
        if (added != null)
            changed[BoundWord] = added.Bound;
        for (int at = HeaderWords; at < words.Length; at += Length(words, at))
        {
            uint op = Op(words, at);
            if (op == OpDecorateString || (op == OpExtension && Text(words, at, 1) == Names))
                continue;
            added?.Before(op, changed);
            int start = changed.Count;
            for (int i = 0; i < Length(words, at); i++)
                changed.Add(words[at + i]);
            if (op == OpDecorate && words[at + 1] == size && words[at + 2] == Location)
                (changed[start + 2], changed[start + 3]) = (BuiltIn, PointSize);
            added?.After(op, changed, start);
        }
        return changed.ToArray();
    }

    static uint Op(uint[] words, int at) => words[at] & 0xffff;
    static int Length(uint[] words, int at) => (int)(words[at] >> 16);

    /// <summary>An output that is 1: the variable, its type and value, and the store at the entry point's beginning.</summary>
    sealed class OnePixel
    {
        readonly uint m_float;
        readonly uint m_entry;
        readonly uint m_pointer;
        readonly uint m_one;
        readonly uint m_variable;
        uint m_function;
        bool m_isDecorated;
        bool m_isDeclared;
        bool m_isInEntry;

        internal OnePixel(uint[] words)
        {
            for (int at = HeaderWords; at < words.Length; at += Length(words, at))
                if (Op(words, at) == OpTypeFloat)
                    m_float = words[at + 1];
                else if (Op(words, at) == OpEntryPoint)
                    m_entry = words[at + 2];
            m_pointer = words[BoundWord];
            m_one = m_pointer + 1;
            m_variable = m_pointer + 2;
            Bound = m_pointer + 3;
        }

        internal uint Bound { get; }

        internal void Before(uint op, List<uint> words)
        {
            if (op == OpDecorate && !m_isDecorated)
            {
                m_isDecorated = true;
                Add(words, OpDecorate, m_variable, BuiltIn, PointSize);
            }
            if (op == OpFunction && !m_isDeclared)
            {
                m_isDeclared = true;
                Add(words, OpTypePointer, m_pointer, Output, m_float);
                Add(words, OpConstant, m_float, m_one, BitConverter.ToUInt32(BitConverter.GetBytes(1f), 0));
                Add(words, OpVariable, m_pointer, m_variable, Output);
            }
            // Variables of the function come first.
            if (m_isInEntry && op != OpVariable && op != OpLabel)
            {
                m_isInEntry = false;
                Add(words, OpStore, m_variable, m_one);
            }
        }

        internal void After(uint op, List<uint> words, int start)
        {
            if (op == OpEntryPoint)
            {
                words[start] += 1u << 16;
                words.Add(m_variable);
            }
            if (op == OpFunction)
                m_function = words[start + 2];
            if (op == OpLabel && m_function == m_entry)
            {
                m_isInEntry = true;
                m_function = 0;
            }
        }

        static void Add(List<uint> words, uint op, params uint[] operands)
        {
            words.Add((uint)(operands.Length + 1) << 16 | op);
            words.AddRange(operands);
        }
    }
}
