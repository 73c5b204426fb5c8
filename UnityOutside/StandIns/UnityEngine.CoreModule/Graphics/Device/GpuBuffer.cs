namespace StandIns.Graphics;

sealed unsafe class GpuBuffer
{
    internal readonly ulong Handle;
    internal readonly ulong Bytes;
    internal readonly GpuAllocation Allocation;
    internal ulong LastUse;

    GpuBuffer(ulong handle, ulong bytes, GpuAllocation allocation) => (Handle, Bytes, Allocation) = (handle, bytes, allocation);

    internal byte* Mapped => Allocation.Mapped;

    /// <summary>A buffer, or null where there is no memory for it.</summary>
    internal static GpuBuffer TryCreate(GpuDevice device, ulong bytes, VkBufferUsageFlags usage, bool isForHost,
        bool isRead = false)
    {
        var create = new VkBufferCreateInfo
        {
            sType = VkStructureType.BufferCreateInfo,
            size = Math.Max(4, bytes),
            usage = usage | VkBufferUsageFlags.TransferSrc | VkBufferUsageFlags.TransferDst,
        };
        ulong handle;
        VkResult result = Vk.vkCreateBuffer(device.Handle, &create, null, &handle);
        if (result == VkResult.ErrorOutOfDeviceMemory || result == VkResult.ErrorOutOfHostMemory)
            return null;
        Vk.Check(result, "vkCreateBuffer");
        VkMemoryRequirements needs;
        Vk.vkGetBufferMemoryRequirements(device.Handle, handle, &needs);
        const VkMemoryPropertyFlags host = VkMemoryPropertyFlags.HostVisible | VkMemoryPropertyFlags.HostCoherent;
        GpuAllocation allocation = device.Memory.Allocate(needs, false, isForHost ? host : VkMemoryPropertyFlags.DeviceLocal,
            isRead ? VkMemoryPropertyFlags.HostCached : 0);
        if (!allocation.IsCreated)
        {
            Vk.vkDestroyBuffer(device.Handle, handle, null);
            return null;
        }
        Vk.Check(Vk.vkBindBufferMemory(device.Handle, handle, allocation.Block.Memory, allocation.Offset), "vkBindBufferMemory");
        return new GpuBuffer(handle, bytes, allocation);
    }

    /// <summary>At once: nothing may still use it.</summary>
    internal void Destroy(GpuDevice device)
    {
        Vk.vkDestroyBuffer(device.Handle, Handle, null);
        device.Memory.Free(Allocation);
    }
}
