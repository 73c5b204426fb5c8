namespace StandIns.Graphics;

/// <summary>Unity's formats and Vulkan's, as far as the package uses them.</summary>
static class TextureFormats
{
    internal static GraphicsFormat Of(RenderTextureFormat format, RenderTextureReadWrite readWrite)
    {
        switch (format)
        {
            case RenderTextureFormat.ARGB32:
            case RenderTextureFormat.Default:
                return readWrite == RenderTextureReadWrite.sRGB ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
            case RenderTextureFormat.ARGBHalf:
            case RenderTextureFormat.DefaultHDR:
                return GraphicsFormat.R16G16B16A16_SFloat;
            case RenderTextureFormat.ARGBFloat:
                return GraphicsFormat.R32G32B32A32_SFloat;
            case RenderTextureFormat.ARGBInt:
                return GraphicsFormat.R32G32B32A32_UInt;
            case RenderTextureFormat.RFloat:
                return GraphicsFormat.R32_SFloat;
            case RenderTextureFormat.RGFloat:
                return GraphicsFormat.R32G32_SFloat;
            case RenderTextureFormat.RInt:
                return GraphicsFormat.R32_SInt;
            case RenderTextureFormat.Depth:
                return GraphicsFormat.None;
            default:
                throw Unknown(format);
        }
    }

    internal static RenderTextureFormat Of(GraphicsFormat format)
    {
        switch (format)
        {
            case GraphicsFormat.R8G8B8A8_SRGB:
            case GraphicsFormat.R8G8B8A8_UNorm:
                return RenderTextureFormat.ARGB32;
            case GraphicsFormat.R16G16B16A16_SFloat:
                return RenderTextureFormat.ARGBHalf;
            case GraphicsFormat.R32G32B32A32_SFloat:
                return RenderTextureFormat.ARGBFloat;
            case GraphicsFormat.R32G32B32A32_UInt:
                return RenderTextureFormat.ARGBInt;
            case GraphicsFormat.R32_SFloat:
                return RenderTextureFormat.RFloat;
            case GraphicsFormat.R32G32_SFloat:
                return RenderTextureFormat.RGFloat;
            case GraphicsFormat.R32_SInt:
            case GraphicsFormat.R32_UInt:
                return RenderTextureFormat.RInt;
            case GraphicsFormat.None:
                return RenderTextureFormat.Depth;
            default:
                throw Unknown(format);
        }
    }

    internal static GraphicsFormat DepthOf(int bits) => bits == 0 ? GraphicsFormat.None : GraphicsFormat.D32_SFloat;

    internal static VkFormat Vulkan(GraphicsFormat format)
    {
        switch (format)
        {
            case GraphicsFormat.R8G8B8A8_SRGB:
                return VkFormat.R8g8b8a8Srgb;
            case GraphicsFormat.R8G8B8A8_UNorm:
                return VkFormat.R8g8b8a8Unorm;
            case GraphicsFormat.R32_UInt:
                return VkFormat.R32Uint;
            case GraphicsFormat.R32_SInt:
                return VkFormat.R32Sint;
            case GraphicsFormat.R32_SFloat:
                return VkFormat.R32Sfloat;
            case GraphicsFormat.R32G32_SFloat:
                return VkFormat.R32g32Sfloat;
            case GraphicsFormat.R16G16B16A16_SFloat:
                return VkFormat.R16g16b16a16Sfloat;
            case GraphicsFormat.R32G32B32A32_UInt:
                return VkFormat.R32g32b32a32Uint;
            case GraphicsFormat.R32G32B32A32_SFloat:
                return VkFormat.R32g32b32a32Sfloat;
            case GraphicsFormat.D32_SFloat:
                return VkFormat.D32Sfloat;
            default:
                throw Unknown(format);
        }
    }

    internal static int TexelBytes(VkFormat format)
    {
        switch (format)
        {
            case VkFormat.R16g16b16a16Sfloat:
            case VkFormat.R32g32Sfloat:
                return 8;
            case VkFormat.R32g32b32a32Uint:
            case VkFormat.R32g32b32a32Sfloat:
                return 16;
            default:
                return 4;
        }
    }

    static NotSupportedException Unknown(Enum format) =>
        new NotSupportedException($"{format.GetType().Name}.{format} is not among the formats that the stand-ins know");
}
