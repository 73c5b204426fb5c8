using System;

namespace StandIns.Vulkan
{
    [Flags]
    enum VkDebugUtilsMessageSeverityFlagsEXT : uint
    {
        Warning = 256,
        Error = 4096,
    }

    [Flags]
    enum VkDebugUtilsMessageTypeFlagsEXT : uint
    {
        General = 1,
        Validation = 2,
        Performance = 4,
    }

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

    unsafe struct VkDebugUtilsMessengerCallbackDataEXT
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public byte* pMessageIdName;
        public int messageIdNumber;
        public byte* pMessage;
        public uint queueLabelCount;
        public void* pQueueLabels;
        public uint cmdBufLabelCount;
        public void* pCmdBufLabels;
        public uint objectCount;
        public void* pObjects;
    }
}
