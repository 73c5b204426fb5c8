namespace StandIns.Vulkan;

[Flags]
enum VkBufferUsageFlags : uint
{
    TransferSrc = 1,
    TransferDst = 2,
    UniformBuffer = 16,
    StorageBuffer = 32,
    IndexBuffer = 64,
    IndirectBuffer = 256,
}

[Flags]
enum VkMemoryPropertyFlags : uint { DeviceLocal = 1, HostVisible = 2, HostCoherent = 4, HostCached = 8 }

unsafe struct VkPhysicalDeviceMemoryProperties
{
    public uint memoryTypeCount;
    /// <summary>32 pairs: property flags, index of the heap.</summary>
    public fixed uint memoryTypes[64];
    public uint memoryHeapCount;
    /// <summary>16 pairs: size in bytes, flags.</summary>
    public fixed ulong memoryHeaps[32];
}

unsafe struct VkMemoryRequirements
{
    public ulong size, alignment;
    public uint memoryTypeBits;
}

unsafe struct VkMemoryAllocateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public ulong allocationSize;
    public uint memoryTypeIndex;
}

unsafe struct VkBufferCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public ulong size;
    public VkBufferUsageFlags usage;
    public uint sharingMode, queueFamilyIndexCount;
    public uint* pQueueFamilyIndices;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern void vkGetPhysicalDeviceMemoryProperties(IntPtr physicalDevice,
        VkPhysicalDeviceMemoryProperties* pMemoryProperties);
    [DllImport(Library)]
    internal static extern VkResult vkAllocateMemory(IntPtr device, VkMemoryAllocateInfo* pAllocateInfo,
        void* pAllocator, ulong* pMemory);
    [DllImport(Library)] internal static extern void vkFreeMemory(IntPtr device, ulong memory, void* pAllocator);
    [DllImport(Library)]
    internal static extern VkResult vkMapMemory(IntPtr device, ulong memory, ulong offset, ulong size, uint flags, void** ppData);
    [DllImport(Library)]
    internal static extern VkResult vkCreateBuffer(IntPtr device, VkBufferCreateInfo* pCreateInfo, void* pAllocator,
        ulong* pBuffer);
    [DllImport(Library)] internal static extern void vkDestroyBuffer(IntPtr device, ulong buffer, void* pAllocator);
    [DllImport(Library)]
    internal static extern void vkGetBufferMemoryRequirements(IntPtr device, ulong buffer,
        VkMemoryRequirements* pMemoryRequirements);
    [DllImport(Library)]
    internal static extern VkResult vkBindBufferMemory(IntPtr device, ulong buffer, ulong memory, ulong memoryOffset);
}
