namespace StandIns.Vulkan;

[StructLayout(LayoutKind.Explicit, Size = 220)]
struct VkPhysicalDeviceFeatures
{
    [FieldOffset(0)] public uint robustBufferAccess;
    [FieldOffset(12)] public uint independentBlend;
    [FieldOffset(16)] public uint geometryShader;
    [FieldOffset(40)] public uint drawIndirectFirstInstance;
    [FieldOffset(100)] public uint vertexPipelineStoresAndAtomics;
    [FieldOffset(104)] public uint fragmentStoresAndAtomics;
    [FieldOffset(128)] public uint shaderStorageImageWriteWithoutFormat;
    [FieldOffset(160)] public uint shaderInt64;
}

unsafe struct VkPhysicalDeviceFeatures2
{
    public VkStructureType sType;
    public void* pNext;
    public VkPhysicalDeviceFeatures features;
}

[StructLayout(LayoutKind.Explicit, Size = 208)]
unsafe struct VkPhysicalDeviceVulkan12Features
{
    [FieldOffset(0)] public VkStructureType sType;
    [FieldOffset(8)] public void* pNext;
    [FieldOffset(140)] public uint scalarBlockLayout;
    [FieldOffset(164)] public uint timelineSemaphore;
    [FieldOffset(192)] public uint shaderOutputViewportIndex;
    [FieldOffset(196)] public uint shaderOutputLayer;
}

[StructLayout(LayoutKind.Explicit, Size = 80)]
unsafe struct VkPhysicalDeviceVulkan13Features
{
    [FieldOffset(0)] public VkStructureType sType;
    [FieldOffset(8)] public void* pNext;
    [FieldOffset(52)] public uint synchronization2;
    [FieldOffset(64)] public uint dynamicRendering;
}

unsafe struct VkDeviceQueueCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, queueFamilyIndex, queueCount;
    public float* pQueuePriorities;
}

unsafe struct VkDeviceCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, queueCreateInfoCount;
    public VkDeviceQueueCreateInfo* pQueueCreateInfos;
    public uint enabledLayerCount;
    public byte** ppEnabledLayerNames;
    public uint enabledExtensionCount;
    public byte** ppEnabledExtensionNames;
    public void* pEnabledFeatures;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern void vkGetPhysicalDeviceFeatures2(IntPtr physicalDevice, VkPhysicalDeviceFeatures2* pFeatures);
    [DllImport(Library)]
    internal static extern VkResult vkEnumerateDeviceExtensionProperties(IntPtr physicalDevice, byte* pLayerName,
        uint* pPropertyCount, VkExtensionProperties* pProperties);
    [DllImport(Library)]
    internal static extern VkResult vkCreateDevice(IntPtr physicalDevice, VkDeviceCreateInfo* pCreateInfo,
        void* pAllocator, IntPtr* pDevice);
    [DllImport(Library)]
    internal static extern void vkGetDeviceQueue(IntPtr device, uint queueFamilyIndex, uint queueIndex, IntPtr* pQueue);
    [DllImport(Library)] internal static extern IntPtr vkGetDeviceProcAddr(IntPtr device, byte* pName);
    [DllImport(Library)] internal static extern VkResult vkDeviceWaitIdle(IntPtr device);
}
