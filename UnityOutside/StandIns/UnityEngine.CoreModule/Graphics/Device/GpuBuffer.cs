namespace StandIns.Graphics;

sealed unsafe class GpuBuffer
{
    internal readonly VkBuffer Handle;
    internal readonly ulong Bytes;
    internal readonly GpuAllocation Allocation;
    internal ulong LastUse;

    GpuBuffer(VkBuffer handle, ulong bytes, GpuAllocation allocation) =>
        (Handle, Bytes, Allocation) = (handle, bytes, allocation);

    internal byte* Mapped => Allocation.Mapped;

    /// <summary>A buffer, or null if there is no memory for it.</summary>
    internal static GpuBuffer TryCreate(GpuDevice device, ulong bytes, BufferUsageFlags usage, bool isForHost,
        bool isRead = false)
    {
        var create = new BufferCreateInfo(size: Math.Max(4, bytes),
            usage: usage | BufferUsageFlags.TransferSrcBit | BufferUsageFlags.TransferDstBit);
        VkBuffer handle;
        Result result = Api.CreateBuffer(device.Handle, &create, null, &handle);
        if (result == Result.ErrorOutOfDeviceMemory || result == Result.ErrorOutOfHostMemory)
            return null;
        Check(result, "vkCreateBuffer");
        MemoryRequirements needs;
        Api.GetBufferMemoryRequirements(device.Handle, handle, &needs);
        const MemoryPropertyFlags host = MemoryPropertyFlags.HostVisibleBit | MemoryPropertyFlags.HostCoherentBit;
        GpuAllocation allocation = device.Memory.Allocate(needs, false, isForHost ? host : MemoryPropertyFlags.DeviceLocalBit,
            isRead ? MemoryPropertyFlags.HostCachedBit : 0);
        if (!allocation.IsCreated)
        {
            Api.DestroyBuffer(device.Handle, handle, null);
            return null;
        }
        Check(Api.BindBufferMemory(device.Handle, handle, allocation.Block.Memory, allocation.Offset), "vkBindBufferMemory");
        return new GpuBuffer(handle, bytes, allocation);
    }

    /// <summary>At once: nothing may still use it.</summary>
    internal void Destroy(GpuDevice device)
    {
        Api.DestroyBuffer(device.Handle, Handle, null);
        device.Memory.Free(Allocation);
    }
}
