namespace StandIns.Vulkan;

[Flags]
enum VkDebugUtilsMessageSeverityFlagsEXT : uint { Warning = 256, Error = 4096 }

[Flags]
enum VkDebugUtilsMessageTypeFlagsEXT : uint { Validation = 2 }

unsafe struct VkDebugUtilsMessengerCreateInfoEXT
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkDebugUtilsMessageSeverityFlagsEXT messageSeverity;
    public VkDebugUtilsMessageTypeFlagsEXT messageType;
    public IntPtr pfnUserCallback;
    public void* pUserData;
}

[StructLayout(LayoutKind.Explicit, Size = 96)]
unsafe struct VkDebugUtilsMessengerCallbackDataEXT
{
    [FieldOffset(40)] public byte* pMessage;
}
