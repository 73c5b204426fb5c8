namespace StandIns.Vulkan;

enum VkFormat : int
{
    Undefined = 0,
    R8g8b8a8Unorm = 37,
    R8g8b8a8Srgb = 43,
    R32Uint = 98,
    R32Sint = 99,
    R32Sfloat = 100,
    R32g32Sfloat = 103,
    R16g16b16a16Sfloat = 97,
    R32g32b32a32Uint = 107,
    R32g32b32a32Sfloat = 109,
    D32Sfloat = 126,
}

struct VkFormatProperties
{
    public uint linearTilingFeatures, optimalTilingFeatures, bufferFeatures;
}

enum VkImageType : int { Type2d = 1 }

[Flags]
enum VkImageUsageFlags : uint
{
    TransferSrc = 1,
    TransferDst = 2,
    Sampled = 4,
    Storage = 8,
    ColorAttachment = 16,
    DepthStencilAttachment = 32,
}

[Flags]
enum VkImageAspectFlags : uint { Color = 1, Depth = 2 }

enum VkImageLayout : int { Undefined = 0, General = 1 }

enum VkImageViewType : int { Type2d = 1, Type2dArray = 5 }

enum VkFilter : int { Nearest = 0, Linear = 1 }

enum VkSamplerAddressMode : int { Repeat = 0, MirroredRepeat = 1, ClampToEdge = 2 }

unsafe struct VkImageCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkImageType imageType;
    public VkFormat format;
    public VkExtent3D extent;
    public uint mipLevels, arrayLayers, samples, tiling;
    public VkImageUsageFlags usage;
    public uint sharingMode, queueFamilyIndexCount;
    public uint* pQueueFamilyIndices;
    public VkImageLayout initialLayout;
}

unsafe struct VkComponentMapping
{
    public uint r, g, b, a;
}

unsafe struct VkImageSubresourceRange
{
    public VkImageAspectFlags aspectMask;
    public uint baseMipLevel, levelCount, baseArrayLayer, layerCount;
}

unsafe struct VkImageSubresourceLayers
{
    public VkImageAspectFlags aspectMask;
    public uint mipLevel, baseArrayLayer, layerCount;
}

unsafe struct VkImageViewCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public ulong image;
    public VkImageViewType viewType;
    public VkFormat format;
    public VkComponentMapping components;
    public VkImageSubresourceRange subresourceRange;
}

unsafe struct VkSamplerCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkFilter magFilter, minFilter;
    public uint mipmapMode;
    public VkSamplerAddressMode addressModeU, addressModeV, addressModeW;
    public float mipLodBias;
    public uint anisotropyEnable;
    public float maxAnisotropy;
    public uint compareEnable;
    public VkCompareOp compareOp;
    public float minLod, maxLod;
    public uint borderColor, unnormalizedCoordinates;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern VkResult vkCreateImage(IntPtr device, VkImageCreateInfo* pCreateInfo, void* pAllocator, ulong* pImage);
    [DllImport(Library)] internal static extern void vkDestroyImage(IntPtr device, ulong image, void* pAllocator);
    [DllImport(Library)]
    internal static extern void vkGetImageMemoryRequirements(IntPtr device, ulong image,
        VkMemoryRequirements* pMemoryRequirements);
    [DllImport(Library)]
    internal static extern VkResult vkBindImageMemory(IntPtr device, ulong image, ulong memory, ulong memoryOffset);
    [DllImport(Library)]
    internal static extern VkResult vkCreateImageView(IntPtr device, VkImageViewCreateInfo* pCreateInfo,
        void* pAllocator, ulong* pView);
    [DllImport(Library)] internal static extern void vkDestroyImageView(IntPtr device, ulong imageView, void* pAllocator);
    [DllImport(Library)]
    internal static extern VkResult vkCreateSampler(IntPtr device, VkSamplerCreateInfo* pCreateInfo, void* pAllocator,
        ulong* pSampler);
}
