namespace UnityEngine.Experimental.Rendering;

public enum GraphicsFormat
{
    None = 0,
    R8G8B8A8_SRGB = 4,
    R8G8B8A8_UNorm = 8,
    R32_UInt = 37,
    R32G32B32A32_UInt = 40,
    R32_SInt = 41,
    R16G16B16A16_SFloat = 48,
    R32_SFloat = 49,
    R32G32_SFloat = 50,
    R32G32B32A32_SFloat = 52,
    D32_SFloat = 93,
}

[Flags]
public enum GraphicsFormatUsage { Blend = 32 }
