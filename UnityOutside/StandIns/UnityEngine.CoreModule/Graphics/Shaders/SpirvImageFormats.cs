namespace StandIns.Graphics;

/// <summary>HLSL does not say what format an RWTexture2D of floats has; glslang says 32-bit floats for it. Where the code only
/// writes such an image, this takes the claim away, so that a texture of any format does.</summary>
static class SpirvImageFormats
{
    const int HeaderWords = 5;
    const uint OpCapability = 17;
    const uint OpTypeImage = 25;
    const uint OpLoad = 61;
    const uint OpImageRead = 98;
    const uint WriteWithoutFormat = 56;
    const int FormatWord = 8;
    // The formats that glslang takes for float4, float2 and float: Rgba32f, Rg32f, R32f.
    static readonly HashSet<uint> s_assumed = new HashSet<uint> { 1, 6, 3 };

    internal static Format Vulkan(uint format) => format switch
    {
        1 => Format.R32G32B32A32Sfloat,
        2 => Format.R16G16B16A16Sfloat,
        3 => Format.R32Sfloat,
        4 => Format.R8G8B8A8Unorm,
        24 => Format.R32Sint,
        30 => Format.R32G32B32A32Uint,
        33 => Format.R32Uint,
        _ => Format.Undefined,
    };

    internal static byte[] WithoutAssumed(byte[] code)
    {
        var words = new uint[code.Length / 4];
        Buffer.BlockCopy(code, 0, words, 0, code.Length);
        var typeOf = new Dictionary<uint, uint>();
        var readTypes = new HashSet<uint>();
        for (int at = HeaderWords; at < words.Length; at += (int)(words[at] >> 16))
            if (Op(words, at) == OpLoad)
                typeOf[words[at + 2]] = words[at + 1];
            else if (Op(words, at) == OpImageRead && typeOf.TryGetValue(words[at + 3], out uint type))
                readTypes.Add(type);
        bool isChanged = false;
        for (int at = HeaderWords; at < words.Length; at += (int)(words[at] >> 16))
            if (Op(words, at) == OpTypeImage && s_assumed.Contains(words[at + FormatWord]) && !readTypes.Contains(words[at + 1]))
            {
                words[at + FormatWord] = 0;
                isChanged = true;
            }
        return isChanged ? WithCapability(words) : code;
    }

    static byte[] WithCapability(uint[] words)
    {
        var changed = new byte[(words.Length + 2) * 4];
        uint[] capability = { 2u << 16 | OpCapability, WriteWithoutFormat };
        Buffer.BlockCopy(words, 0, changed, 0, HeaderWords * 4);
        Buffer.BlockCopy(capability, 0, changed, HeaderWords * 4, 8);
        Buffer.BlockCopy(words, HeaderWords * 4, changed, (HeaderWords + 2) * 4, (words.Length - HeaderWords) * 4);
        return changed;
    }

    static uint Op(uint[] words, int at) => words[at] & 0xffff;
}
