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

    internal static VkFormat Vulkan(GraphicsFormat format) => format switch
    {
        GraphicsFormat.R8G8B8A8_SRGB => VkFormat.R8g8b8a8Srgb,
        GraphicsFormat.R8G8B8A8_UNorm => VkFormat.R8g8b8a8Unorm,
        GraphicsFormat.R32_UInt => VkFormat.R32Uint,
        GraphicsFormat.R32_SInt => VkFormat.R32Sint,
        GraphicsFormat.R32_SFloat => VkFormat.R32Sfloat,
        GraphicsFormat.R32G32_SFloat => VkFormat.R32g32Sfloat,
        GraphicsFormat.R16G16B16A16_SFloat => VkFormat.R16g16b16a16Sfloat,
        GraphicsFormat.R32G32B32A32_UInt => VkFormat.R32g32b32a32Uint,
        GraphicsFormat.R32G32B32A32_SFloat => VkFormat.R32g32b32a32Sfloat,
        GraphicsFormat.D32_SFloat => VkFormat.D32Sfloat,
        _ => throw Unknown(format),
    };

    internal static int TexelBytes(VkFormat format) => format switch
    {
        VkFormat.R16g16b16a16Sfloat or VkFormat.R32g32Sfloat => 8,
        VkFormat.R32g32b32a32Uint or VkFormat.R32g32b32a32Sfloat => 16,
        _ => 4,
    };

    static NotSupportedException Unknown(Enum format) =>
        new NotSupportedException($"{format.GetType().Name}.{format} is not among the formats that the stand-ins know");
}
