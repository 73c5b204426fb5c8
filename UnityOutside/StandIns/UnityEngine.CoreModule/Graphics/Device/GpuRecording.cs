namespace StandIns.Graphics;

sealed unsafe class GpuRecording
{
    internal readonly VkCommandBuffer Commands;
    internal readonly UploadArena Uploads;
    readonly GpuDevice m_device;
    readonly CommandPool m_pool;

    internal GpuRecording(GpuDevice device, uint family)
    {
        m_device = device;
        Uploads = new UploadArena(device);
        var pool = new CommandPoolCreateInfo(queueFamilyIndex: family);
        CommandPool handle;
        Check(Api.CreateCommandPool(device.Handle, &pool, null, &handle), "vkCreateCommandPool");
        m_pool = handle;
        var allocate = new CommandBufferAllocateInfo(commandPool: m_pool, commandBufferCount: 1);
        VkCommandBuffer commands;
        Check(Api.AllocateCommandBuffers(device.Handle, &allocate, &commands), "vkAllocateCommandBuffers");
        Commands = commands;
    }

    internal ulong Number { get; private set; }

    internal void Begin(ulong number)
    {
        Number = number;
        Uploads.Reset();
        Check(Api.ResetCommandPool(m_device.Handle, m_pool, 0), "vkResetCommandPool");
        var begin = new CommandBufferBeginInfo(flags: CommandBufferUsageFlags.OneTimeSubmitBit);
        Check(Api.BeginCommandBuffer(Commands, &begin), "vkBeginCommandBuffer");
    }

    internal void End()
    {
        // What was written is there for the host, once it has waited.
        Barrier(PipelineStageFlags2.AllCommandsBit | PipelineStageFlags2.HostBit,
            AccessFlags2.MemoryReadBit | AccessFlags2.HostReadBit);
        Check(Api.EndCommandBuffer(Commands), "vkEndCommandBuffer");
    }

    /// <summary>What comes after sees what came before. One barrier for everything, between all dispatches, copies and passes:
    /// not the quickest way, but never wrong.</summary>
    internal void Barrier() =>
        Barrier(PipelineStageFlags2.AllCommandsBit, AccessFlags2.MemoryReadBit | AccessFlags2.MemoryWriteBit);

    internal void Copy(GpuBuffer source, ulong sourceOffset, GpuBuffer destination, ulong destinationOffset, ulong bytes)
    {
        var region = new BufferCopy { SrcOffset = sourceOffset, DstOffset = destinationOffset, Size = bytes };
        Api.CmdCopyBuffer(Commands, source.Handle, destination.Handle, 1, &region);
        source.LastUse = Number;
        destination.LastUse = Number;
    }

    void Barrier(PipelineStageFlags2 later, AccessFlags2 access)
    {
        var memory = new MemoryBarrier2(srcStageMask: PipelineStageFlags2.AllCommandsBit,
            srcAccessMask: AccessFlags2.MemoryWriteBit, dstStageMask: later, dstAccessMask: access);
        var dependency = new DependencyInfo(memoryBarrierCount: 1, pMemoryBarriers: &memory);
        Api.CmdPipelineBarrier2(Commands, &dependency);
    }
}
