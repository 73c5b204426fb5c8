namespace StandIns.Graphics;

sealed unsafe class GpuRecording
{
    internal readonly IntPtr Commands;
    internal readonly UploadArena Uploads;
    readonly GpuDevice m_device;
    readonly ulong m_pool;

    internal GpuRecording(GpuDevice device, uint family)
    {
        m_device = device;
        Uploads = new UploadArena(device);
        var pool = new VkCommandPoolCreateInfo
        {
            sType = VkStructureType.CommandPoolCreateInfo,
            queueFamilyIndex = family,
        };
        ulong handle;
        Vk.Check(Vk.vkCreateCommandPool(device.Handle, &pool, null, &handle), "vkCreateCommandPool");
        m_pool = handle;
        var allocate = new VkCommandBufferAllocateInfo
        {
            sType = VkStructureType.CommandBufferAllocateInfo,
            commandPool = m_pool,
            commandBufferCount = 1,
        };
        IntPtr commands;
        Vk.Check(Vk.vkAllocateCommandBuffers(device.Handle, &allocate, &commands), "vkAllocateCommandBuffers");
        Commands = commands;
    }

    internal ulong Number { get; private set; }

    internal void Begin(ulong number)
    {
        Number = number;
        Uploads.Reset();
        Vk.Check(Vk.vkResetCommandPool(m_device.Handle, m_pool, 0), "vkResetCommandPool");
        const uint oneTime = 1;
        var begin = new VkCommandBufferBeginInfo { sType = VkStructureType.CommandBufferBeginInfo, flags = oneTime };
        Vk.Check(Vk.vkBeginCommandBuffer(Commands, &begin), "vkBeginCommandBuffer");
    }

    internal void End()
    {
        // What was written is there for the host, once it has waited.
        Barrier(VkPipelineStageFlags2.AllCommands | VkPipelineStageFlags2.Host,
            VkAccessFlags2.MemoryRead | VkAccessFlags2.HostRead);
        Vk.Check(Vk.vkEndCommandBuffer(Commands), "vkEndCommandBuffer");
    }

    /// <summary>What comes after sees what came before. One barrier for everything, between all dispatches, copies and passes:
    /// not the quickest way, but never wrong.</summary>
    internal void Barrier() => Barrier(VkPipelineStageFlags2.AllCommands, VkAccessFlags2.MemoryRead | VkAccessFlags2.MemoryWrite);

    internal void Copy(GpuBuffer source, ulong sourceOffset, GpuBuffer destination, ulong destinationOffset, ulong bytes)
    {
        var region = new VkBufferCopy { srcOffset = sourceOffset, dstOffset = destinationOffset, size = bytes };
        Vk.vkCmdCopyBuffer(Commands, source.Handle, destination.Handle, 1, &region);
        source.LastUse = Number;
        destination.LastUse = Number;
    }

    void Barrier(VkPipelineStageFlags2 later, VkAccessFlags2 access)
    {
        var memory = new VkMemoryBarrier2
        {
            sType = VkStructureType.MemoryBarrier2,
            srcStageMask = VkPipelineStageFlags2.AllCommands,
            srcAccessMask = VkAccessFlags2.MemoryWrite,
            dstStageMask = later,
            dstAccessMask = access,
        };
        var dependency = new VkDependencyInfo
        {
            sType = VkStructureType.DependencyInfo,
            memoryBarrierCount = 1,
            pMemoryBarriers = &memory,
        };
        Vk.vkCmdPipelineBarrier2(Commands, &dependency);
    }
}
