namespace StandIns.Graphics;

/// <summary>Unity's formats and Vulkan's, as far as the package uses them.</summary>
static class TextureFormats
{
    internal static GraphicsFormat Of(RenderTextureFormat format, RenderTextureReadWrite readWrite) => format switch
    {
        RenderTextureFormat.ARGB32 or RenderTextureFormat.Default =>
            readWrite == RenderTextureReadWrite.sRGB ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm,
        RenderTextureFormat.ARGBHalf or RenderTextureFormat.DefaultHDR => GraphicsFormat.R16G16B16A16_SFloat,
        RenderTextureFormat.ARGBFloat => GraphicsFormat.R32G32B32A32_SFloat,
        RenderTextureFormat.ARGBInt => GraphicsFormat.R32G32B32A32_UInt,
        RenderTextureFormat.RFloat => GraphicsFormat.R32_SFloat,
        RenderTextureFormat.RGFloat => GraphicsFormat.R32G32_SFloat,
        RenderTextureFormat.RInt => GraphicsFormat.R32_SInt,
        RenderTextureFormat.Depth => GraphicsFormat.None,
        _ => throw Unknown(format),
    };

    internal static GraphicsFormat DepthOf(int bits) => bits == 0 ? GraphicsFormat.None : GraphicsFormat.D32_SFloat;

    internal static Format Vulkan(GraphicsFormat format) => format switch
    {
        GraphicsFormat.R8G8B8A8_SRGB => Format.R8G8B8A8Srgb,
        GraphicsFormat.R8G8B8A8_UNorm => Format.R8G8B8A8Unorm,
        GraphicsFormat.R32_UInt => Format.R32Uint,
        GraphicsFormat.R32_SInt => Format.R32Sint,
        GraphicsFormat.R32_SFloat => Format.R32Sfloat,
        GraphicsFormat.R32G32_SFloat => Format.R32G32Sfloat,
        GraphicsFormat.R16G16B16A16_SFloat => Format.R16G16B16A16Sfloat,
        GraphicsFormat.R32G32B32A32_UInt => Format.R32G32B32A32Uint,
        GraphicsFormat.R32G32B32A32_SFloat => Format.R32G32B32A32Sfloat,
        GraphicsFormat.D32_SFloat => Format.D32Sfloat,
        _ => throw Unknown(format),
    };

    internal static int TexelBytes(Format format) => format switch
    {
        Format.R16G16B16A16Sfloat or Format.R32G32Sfloat => 8,
        Format.R32G32B32A32Uint or Format.R32G32B32A32Sfloat => 16,
        _ => 4,
    };

    static NotSupportedException Unknown(Enum format) =>
        new NotSupportedException($"{format.GetType().Name}.{format} is not among the formats that the stand-ins know");
}
