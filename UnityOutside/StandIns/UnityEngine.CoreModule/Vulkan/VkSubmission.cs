namespace StandIns.Vulkan;

enum VkSemaphoreType : int { Timeline = 1 }

[Flags]
enum VkPipelineStageFlags2 : ulong { AllCommands = 65536, Host = 16384 }

[Flags]
enum VkAccessFlags2 : ulong { MemoryRead = 32768, MemoryWrite = 65536, HostRead = 8192 }

unsafe struct VkCommandPoolCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, queueFamilyIndex;
}

unsafe struct VkCommandBufferAllocateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public ulong commandPool;
    public uint level, commandBufferCount;
}

unsafe struct VkCommandBufferBeginInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public void* pInheritanceInfo;
}

unsafe struct VkSemaphoreTypeCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public VkSemaphoreType semaphoreType;
    public ulong initialValue;
}

unsafe struct VkSemaphoreCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
}

unsafe struct VkSemaphoreWaitInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, semaphoreCount;
    public ulong* pSemaphores, pValues;
}

unsafe struct VkSemaphoreSubmitInfo
{
    public VkStructureType sType;
    public void* pNext;
    public ulong semaphore, value;
    public VkPipelineStageFlags2 stageMask;
    public uint deviceIndex;
}

unsafe struct VkCommandBufferSubmitInfo
{
    public VkStructureType sType;
    public void* pNext;
    public IntPtr commandBuffer;
    public uint deviceMask;
}

unsafe struct VkSubmitInfo2
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, waitSemaphoreInfoCount;
    public VkSemaphoreSubmitInfo* pWaitSemaphoreInfos;
    public uint commandBufferInfoCount;
    public VkCommandBufferSubmitInfo* pCommandBufferInfos;
    public uint signalSemaphoreInfoCount;
    public VkSemaphoreSubmitInfo* pSignalSemaphoreInfos;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern VkResult vkCreateCommandPool(IntPtr device, VkCommandPoolCreateInfo* pCreateInfo,
        void* pAllocator, ulong* pCommandPool);
    [DllImport(Library)] internal static extern VkResult vkResetCommandPool(IntPtr device, ulong commandPool, uint flags);
    [DllImport(Library)]
    internal static extern VkResult vkAllocateCommandBuffers(IntPtr device, VkCommandBufferAllocateInfo* pAllocateInfo,
        IntPtr* pCommandBuffers);
    [DllImport(Library)]
    internal static extern VkResult vkBeginCommandBuffer(IntPtr commandBuffer, VkCommandBufferBeginInfo* pBeginInfo);
    [DllImport(Library)] internal static extern VkResult vkEndCommandBuffer(IntPtr commandBuffer);
    [DllImport(Library)]
    internal static extern VkResult vkQueueSubmit2(IntPtr queue, uint submitCount, VkSubmitInfo2* pSubmits, ulong fence);
    [DllImport(Library)]
    internal static extern VkResult vkCreateSemaphore(IntPtr device, VkSemaphoreCreateInfo* pCreateInfo,
        void* pAllocator, ulong* pSemaphore);
    [DllImport(Library)]
    internal static extern VkResult vkWaitSemaphores(IntPtr device, VkSemaphoreWaitInfo* pWaitInfo, ulong timeout);
    [DllImport(Library)]
    internal static extern VkResult vkGetSemaphoreCounterValue(IntPtr device, ulong semaphore, ulong* pValue);
}
