namespace StandIns.Graphics;

sealed unsafe class GpuMemory
{
    const ulong BlockBytes = 16 << 20;
    const ulong LargeBytes = BlockBytes / 4;

    readonly GpuDevice m_device;
    readonly VkPhysicalDeviceMemoryProperties m_properties;
    readonly List<GpuMemoryBlock> m_blocks = new List<GpuMemoryBlock>();
    ulong m_usedBytes;

    internal GpuMemory(GpuDevice device)
    {
        m_device = device;
        VkPhysicalDeviceMemoryProperties properties;
        Vk.vkGetPhysicalDeviceMemoryProperties(device.Physical, &properties);
        m_properties = properties;
    }

    internal ulong LimitBytes { get; set; } = ulong.MaxValue;

    internal ulong UsedBytes
    {
        get
        {
            lock (m_blocks)
                return m_usedBytes;
        }
    }

    /// <param name="wanted">What the memory must be; <paramref name="liked"/> what it had better be.</param>
    internal GpuAllocation Allocate(VkMemoryRequirements needs, bool isImage, VkMemoryPropertyFlags wanted,
        VkMemoryPropertyFlags liked)
    {
        int type = TypeFor(needs.memoryTypeBits, wanted | liked);
        if (type < 0)
            type = TypeFor(needs.memoryTypeBits, wanted);
        if (type < 0)
            return default;
        lock (m_blocks)
        {
            if (m_usedBytes + needs.size > LimitBytes)
                return default;
            bool isLarge = needs.size >= LargeBytes;
            foreach (GpuMemoryBlock block in m_blocks)
                if (!isLarge && block.Fits(type, isImage) && block.TryTake(needs.size, needs.alignment, out ulong at))
                    return Count(new GpuAllocation(block, at, needs.size));
            GpuMemoryBlock added = AddBlock(type, isImage, isLarge ? needs.size : BlockBytes, isLarge);
            if (added == null)
                return default;
            added.TryTake(needs.size, needs.alignment, out ulong start);
            return Count(new GpuAllocation(added, start, needs.size));
        }
    }

    internal void Free(in GpuAllocation allocation)
    {
        if (!allocation.IsCreated)
            return;
        lock (m_blocks)
        {
            m_usedBytes -= allocation.Bytes;
            allocation.Block.Give(allocation.Offset, allocation.Bytes);
            if (!allocation.Block.IsLarge || !allocation.Block.IsEmpty)
                return;
            m_blocks.Remove(allocation.Block);
            Vk.vkFreeMemory(m_device.Handle, allocation.Block.Memory, null);
        }
    }

    GpuAllocation Count(GpuAllocation allocation)
    {
        m_usedBytes += allocation.Bytes;
        return allocation;
    }

    GpuMemoryBlock AddBlock(int type, bool isImage, ulong bytes, bool isLarge)
    {
        var allocate = new VkMemoryAllocateInfo
        {
            sType = VkStructureType.MemoryAllocateInfo,
            allocationSize = bytes,
            memoryTypeIndex = (uint)type,
        };
        ulong memory;
        if (Vk.vkAllocateMemory(m_device.Handle, &allocate, null, &memory) != VkResult.Success)
            return null;
        void* mapped = null;
        if ((FlagsOf(type) & VkMemoryPropertyFlags.HostVisible) != 0)
            Vk.Check(Vk.vkMapMemory(m_device.Handle, memory, 0, Vk.WholeSize, 0, &mapped), "vkMapMemory");
        var block = new GpuMemoryBlock(memory, (byte*)mapped, bytes, type, isImage, isLarge);
        m_blocks.Add(block);
        return block;
    }

    int TypeFor(uint allowed, VkMemoryPropertyFlags wanted)
    {
        for (int type = 0; type < m_properties.memoryTypeCount; type++)
            if ((allowed >> type & 1) != 0 && (FlagsOf(type) & wanted) == wanted)
                return type;
        return -1;
    }

    VkMemoryPropertyFlags FlagsOf(int type)
    {
        fixed (uint* pairs = m_properties.memoryTypes)
            return (VkMemoryPropertyFlags)pairs[type * 2];
    }
}
