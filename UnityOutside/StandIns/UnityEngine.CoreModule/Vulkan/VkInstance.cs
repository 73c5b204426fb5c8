namespace StandIns.Vulkan;

enum VkResult : int
{
    Success = 0,
    NotReady = 1,
    Timeout = 2,
    Incomplete = 5,
    ErrorOutOfHostMemory = -1,
    ErrorOutOfDeviceMemory = -2,
    ErrorInitializationFailed = -3,
    ErrorDeviceLost = -4,
    ErrorLayerNotPresent = -6,
    ErrorExtensionNotPresent = -7,
    ErrorFeatureNotPresent = -8,
    ErrorIncompatibleDriver = -9,
}

enum VkPhysicalDeviceType : int { IntegratedGpu = 1, DiscreteGpu = 2, VirtualGpu = 3 }

[Flags]
enum VkQueueFlags : uint { Graphics = 1, Compute = 2 }

unsafe struct VkApplicationInfo
{
    public VkStructureType sType;
    public void* pNext;
    public byte* pApplicationName;
    public uint applicationVersion;
    public byte* pEngineName;
    public uint engineVersion, apiVersion;
}

unsafe struct VkInstanceCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkApplicationInfo* pApplicationInfo;
    public uint enabledLayerCount;
    public byte** ppEnabledLayerNames;
    public uint enabledExtensionCount;
    public byte** ppEnabledExtensionNames;
}

unsafe struct VkLayerProperties
{
    public fixed byte layerName[256];
    public uint specVersion, implementationVersion;
    public fixed byte description[256];
}

unsafe struct VkExtensionProperties
{
    public fixed byte extensionName[256];
    public uint specVersion;
}

[StructLayout(LayoutKind.Explicit, Size = 504)]
struct VkPhysicalDeviceLimits
{
    [FieldOffset(4)] public uint maxImageDimension2D;
    [FieldOffset(28)] public uint maxStorageBufferRange;
    [FieldOffset(76)] public uint maxPerStageDescriptorStorageBuffers;
    [FieldOffset(232)] public uint maxComputeWorkGroupInvocations;
}

[StructLayout(LayoutKind.Explicit, Size = 824)]
unsafe struct VkPhysicalDeviceProperties
{
    [FieldOffset(0)] public uint apiVersion;
    [FieldOffset(16)] public VkPhysicalDeviceType deviceType;
    [FieldOffset(20)] public fixed byte deviceName[256];
    [FieldOffset(296)] public VkPhysicalDeviceLimits limits;
}

unsafe struct VkExtent3D
{
    public uint width, height, depth;
}

unsafe struct VkQueueFamilyProperties
{
    public VkQueueFlags queueFlags;
    public uint queueCount, timestampValidBits;
    public VkExtent3D minImageTransferGranularity;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern VkResult vkCreateInstance(VkInstanceCreateInfo* pCreateInfo, void* pAllocator, IntPtr* pInstance);
    [DllImport(Library)]
    internal static extern VkResult vkEnumerateInstanceLayerProperties(uint* pPropertyCount, VkLayerProperties* pProperties);
    [DllImport(Library)]
    internal static extern VkResult vkEnumeratePhysicalDevices(IntPtr instance, uint* pPhysicalDeviceCount,
        IntPtr* pPhysicalDevices);
    [DllImport(Library)]
    internal static extern void vkGetPhysicalDeviceFormatProperties(IntPtr physicalDevice, VkFormat format,
        VkFormatProperties* pFormatProperties);
    [DllImport(Library)]
    internal static extern void vkGetPhysicalDeviceProperties(IntPtr physicalDevice, VkPhysicalDeviceProperties* pProperties);
    [DllImport(Library)]
    internal static extern void vkGetPhysicalDeviceQueueFamilyProperties(IntPtr physicalDevice,
        uint* pQueueFamilyPropertyCount, VkQueueFamilyProperties* pQueueFamilyProperties);
    [DllImport(Library)] internal static extern IntPtr vkGetInstanceProcAddr(IntPtr instance, byte* pName);
}
