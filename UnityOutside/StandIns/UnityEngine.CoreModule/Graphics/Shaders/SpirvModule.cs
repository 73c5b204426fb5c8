namespace StandIns.Graphics;

/// <summary>Compiled shader code of one stage, as words, and what it says of its resources (SPIR-V 1.3, section 3). Only what
/// glslang makes of HLSL is understood.</summary>
sealed class SpirvModule
{
    const uint Magic = 0x07230203;
    const int HeaderWords = 5;

    readonly Dictionary<uint, string> m_names = new Dictionary<uint, string>();
    readonly Dictionary<(uint Type, uint Member), string> m_memberNames = new Dictionary<(uint, uint), string>();
    readonly Dictionary<(uint Target, uint Member, Decoration Kind), uint> m_decorations =
        new Dictionary<(uint, uint, Decoration), uint>();
    // Where in the words a decoration's value stands.
    readonly Dictionary<(uint Target, Decoration Kind), int> m_valueAt = new Dictionary<(uint, Decoration), int>();
    readonly Dictionary<uint, int> m_instructionOf = new Dictionary<uint, int>();
    readonly List<int> m_variables = new List<int>();

    internal SpirvModule(byte[] bytes)
    {
        Words = new uint[bytes.Length / 4];
        Buffer.BlockCopy(bytes, 0, Words, 0, Words.Length * 4);
        if (Words.Length < HeaderWords || Words[0] != Magic)
            throw new InvalidDataException("Not SPIR-V");
        Read();
    }

    internal enum Decoration : uint
    {
        Block = 2,
        BufferBlock = 3,
        ArrayStride = 6,
        MatrixStride = 7,
        NonWritable = 24,
        Binding = 33,
        Offset = 35,
    }

    enum Op : uint
    {
        Name = 5,
        MemberName = 6,
        TypeInt = 21,
        TypeFloat = 22,
        TypeVector = 23,
        TypeMatrix = 24,
        TypeImage = 25,
        TypeSampler = 26,
        TypeArray = 28,
        TypeRuntimeArray = 29,
        TypeStruct = 30,
        TypePointer = 32,
        Constant = 43,
        Variable = 59,
        Decorate = 71,
        MemberDecorate = 72,
    }

    internal uint[] Words { get; }

    internal static SpirvModule For(GpuDevice device, byte[] code) =>
        new SpirvModule(device.WritesAnyFormat ? SpirvImageFormats.WithoutAssumed(code) : code);

    internal List<ShaderResource> Resources()
    {
        var resources = new List<ShaderResource>();
        foreach (int at in m_variables)
        {
            uint variable = Words[at + 2];
            if (!m_valueAt.ContainsKey((variable, Decoration.Binding)))
                continue;
            uint type = Words[m_instructionOf[Words[at + 1]] + 3];
            resources.Add(Describe(variable, type));
        }
        return resources;
    }

    internal void SetBinding(ShaderResource resource, int binding) =>
        Words[m_valueAt[(resource.Variable, Decoration.Binding)]] = (uint)binding;

    ShaderResource Describe(uint variable, uint type)
    {
        int at = m_instructionOf[type];
        switch (OpAt(at))
        {
            case Op.TypeSampler:
                return new ShaderResource(variable, m_names[variable], DescriptorType.Sampler);
            case Op.TypeImage:
                const uint storage = 2;
                DescriptorType kind = Words[at + 7] == storage ? DescriptorType.StorageImage
                    : DescriptorType.SampledImage;
                return new ShaderResource(variable, m_names[variable], kind)
                {
                    IsArray = Words[at + 5] != 0,
                    Format = SpirvImageFormats.Vulkan(Words[at + 8]),
                };
            case Op.TypeStruct when m_decorations.ContainsKey((type, uint.MaxValue, Decoration.BufferBlock)):
                return new ShaderResource(variable, m_names[variable], DescriptorType.StorageBuffer)
                {
                    Stride = (int)Decorated(Words[at + 2], Decoration.ArrayStride),
                    IsWritten = !m_decorations.ContainsKey((type, 0, Decoration.NonWritable)),
                };
            case Op.TypeStruct:
                return new ShaderResource(variable, m_names[type], DescriptorType.UniformBuffer)
                { Members = MembersOf(type, at) };
            default:
                throw new InvalidDataException($"{m_names[variable]}: resources of this kind (an array of them?) are not "
                    + $"supported");
        }
    }

    ShaderMember[] MembersOf(uint type, int at)
    {
        var members = new ShaderMember[(Words[at] >> 16) - 2];
        for (uint i = 0; i < members.Length; i++)
        {
            var member = new ShaderMember(m_memberNames[(type, i)], (int)m_decorations[(type, i, Decoration.Offset)]);
            uint memberType = Words[at + 2 + i];
            int typeAt = m_instructionOf[memberType];
            if (OpAt(typeAt) == Op.TypeArray)
            {
                member.Stride = (int)Decorated(memberType, Decoration.ArrayStride);
                member.Count = (int)Words[m_instructionOf[Words[typeAt + 3]] + 3];
                typeAt = m_instructionOf[Words[typeAt + 2]];
            }
            if (OpAt(typeAt) == Op.TypeMatrix)
            {
                member.Columns = (int)Words[typeAt + 3];
                typeAt = m_instructionOf[Words[typeAt + 2]];
            }
            if (OpAt(typeAt) == Op.TypeVector)
            {
                member.Rows = (int)Words[typeAt + 3];
                typeAt = m_instructionOf[Words[typeAt + 2]];
            }
            member.IsFloat = OpAt(typeAt) == Op.TypeFloat;
            members[i] = member;
        }
        return members;
    }

    uint Decorated(uint target, Decoration kind) =>
        m_decorations.TryGetValue((target, uint.MaxValue, kind), out uint value) ? value : 0;

    void Read()
    {
        for (int at = HeaderWords; at < Words.Length; at += (int)(Words[at] >> 16))
            switch (OpAt(at))
            {
                case Op.Name:
                    m_names[Words[at + 1]] = Text(at + 2);
                    break;
                case Op.MemberName:
                    m_memberNames[(Words[at + 1], Words[at + 2])] = Text(at + 3);
                    break;
                case Op.Decorate:
                    var decoration = (Decoration)Words[at + 2];
                    bool hasValue = Words[at] >> 16 > 3;
                    m_decorations[(Words[at + 1], uint.MaxValue, decoration)] = hasValue ? Words[at + 3] : 1;
                    m_valueAt[(Words[at + 1], decoration)] = at + 3;
                    break;
                case Op.MemberDecorate:
                    m_decorations[(Words[at + 1], Words[at + 2], (Decoration)Words[at + 3])] =
                        Words[at] >> 16 > 4 ? Words[at + 4] : 1;
                    break;
                case Op.TypeInt:
                case Op.TypeFloat:
                case Op.TypeVector:
                case Op.TypeMatrix:
                case Op.TypeImage:
                case Op.TypeSampler:
                case Op.TypeArray:
                case Op.TypeRuntimeArray:
                case Op.TypeStruct:
                case Op.TypePointer:
                    m_instructionOf[Words[at + 1]] = at;
                    break;
                case Op.Constant:
                    m_instructionOf[Words[at + 2]] = at;
                    break;
                case Op.Variable:
                    m_variables.Add(at);
                    break;
            }
    }

    Op OpAt(int at) => (Op)(Words[at] & 0xffff);

    string Text(int at)
    {
        var bytes = new List<byte>();
        for (; ; at++)
            for (int shift = 0; shift < 32; shift += 8)
            {
                byte b = (byte)(Words[at] >> shift);
                if (b == 0)
                    return Encoding.UTF8.GetString(bytes.ToArray());
                bytes.Add(b);
            }
    }
}
