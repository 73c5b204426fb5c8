namespace StandIns.Graphics;

sealed unsafe class GpuMemory
{
    const ulong BlockBytes = 16 << 20;
    const ulong LargeBytes = BlockBytes / 4;

    readonly GpuDevice m_device;
    readonly PhysicalDeviceMemoryProperties m_properties;
    readonly List<GpuMemoryBlock> m_blocks = new List<GpuMemoryBlock>();
    ulong m_usedBytes;

    internal GpuMemory(GpuDevice device)
    {
        m_device = device;
        m_properties = Api.GetPhysicalDeviceMemoryProperties(device.Physical);
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
    internal GpuAllocation Allocate(MemoryRequirements needs, bool isImage, MemoryPropertyFlags wanted,
        MemoryPropertyFlags liked)
    {
        int type = TypeFor(needs.MemoryTypeBits, wanted | liked);
        if (type < 0)
            type = TypeFor(needs.MemoryTypeBits, wanted);
        if (type < 0)
            return default;
        lock (m_blocks)
        {
            if (m_usedBytes + needs.Size > LimitBytes)
                return default;
            bool isLarge = needs.Size >= LargeBytes;
            foreach (GpuMemoryBlock block in m_blocks)
                if (!isLarge && block.Fits(type, isImage) && block.TryTake(needs.Size, needs.Alignment, out ulong at))
                    return Count(new GpuAllocation(block, at, needs.Size));
            GpuMemoryBlock added = AddBlock(type, isImage, isLarge ? needs.Size : BlockBytes, isLarge);
            if (added == null)
                return default;
            added.TryTake(needs.Size, needs.Alignment, out ulong start);
            return Count(new GpuAllocation(added, start, needs.Size));
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
            Api.FreeMemory(m_device.Handle, allocation.Block.Memory, null);
        }
    }

    GpuAllocation Count(GpuAllocation allocation)
    {
        m_usedBytes += allocation.Bytes;
        return allocation;
    }

    GpuMemoryBlock AddBlock(int type, bool isImage, ulong bytes, bool isLarge)
    {
        var allocate = new MemoryAllocateInfo(allocationSize: bytes, memoryTypeIndex: (uint)type);
        DeviceMemory memory;
        if (Api.AllocateMemory(m_device.Handle, &allocate, null, &memory) != Result.Success)
            return null;
        void* mapped = null;
        if ((FlagsOf(type) & MemoryPropertyFlags.HostVisibleBit) != 0)
            Check(Api.MapMemory(m_device.Handle, memory, 0, Vk.WholeSize, 0, &mapped), "vkMapMemory");
        var block = new GpuMemoryBlock(memory, (byte*)mapped, bytes, type, isImage, isLarge);
        m_blocks.Add(block);
        return block;
    }

    int TypeFor(uint allowed, MemoryPropertyFlags wanted)
    {
        for (int type = 0; type < m_properties.MemoryTypeCount; type++)
            if ((allowed >> type & 1) != 0 && (FlagsOf(type) & wanted) == wanted)
                return type;
        return -1;
    }

    MemoryPropertyFlags FlagsOf(int type) => m_properties.MemoryTypes[type].PropertyFlags;
}
