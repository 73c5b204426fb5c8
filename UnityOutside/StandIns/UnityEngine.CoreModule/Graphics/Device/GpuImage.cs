using System.Diagnostics;

namespace StandIns.Graphics;

sealed unsafe class GpuImage
{
    internal readonly ulong Handle;
    internal readonly ulong View;
    internal readonly VkFormat Format;
    internal readonly int Width;
    internal readonly int Height;
    internal readonly int Slices;
    readonly GpuAllocation m_allocation;
    // Of one slice each, made when first asked for, and of all slices as an attachment.
    readonly ulong[] m_attachments;

    GpuImage(GpuDevice device, ulong handle, in GpuAllocation allocation, in VkImageCreateInfo create, bool isArray)
    {
        Handle = handle;
        m_allocation = allocation;
        Format = create.format;
        Width = (int)create.extent.width;
        Height = (int)create.extent.height;
        Slices = (int)create.arrayLayers;
        View = MakeView(device, isArray ? VkImageViewType.Type2dArray : VkImageViewType.Type2d, 0, Slices);
        m_attachments = new ulong[Slices + 1];
    }

    internal bool IsDepth => Format == VkFormat.D32Sfloat;
    internal VkImageAspectFlags Aspect => IsDepth ? VkImageAspectFlags.Depth : VkImageAspectFlags.Color;

    /// <summary>An image, or null where there is no memory for it.</summary>
    internal static GpuImage TryCreate(GpuDevice device, VkFormat format, (int Width, int Height) size, int slices,
        bool isArray, bool isWritten)
    {
        bool isDepth = format == VkFormat.D32Sfloat;
        var create = new VkImageCreateInfo
        {
            sType = VkStructureType.ImageCreateInfo,
            imageType = VkImageType.Type2d,
            format = format,
            extent = new VkExtent3D { width = (uint)size.Width, height = (uint)size.Height, depth = 1 },
            mipLevels = 1,
            arrayLayers = (uint)slices,
            samples = 1,
            usage = VkImageUsageFlags.Sampled | VkImageUsageFlags.TransferSrc | VkImageUsageFlags.TransferDst
                | (isDepth ? VkImageUsageFlags.DepthStencilAttachment : VkImageUsageFlags.ColorAttachment)
                | (isWritten ? VkImageUsageFlags.Storage : 0),
            initialLayout = VkImageLayout.Undefined,
        };
        ulong handle;
        Vk.Check(Vk.vkCreateImage(device.Handle, &create, null, &handle), "vkCreateImage");
        VkMemoryRequirements needs;
        Vk.vkGetImageMemoryRequirements(device.Handle, handle, &needs);
        GpuAllocation allocation = device.Memory.Allocate(needs, true, VkMemoryPropertyFlags.DeviceLocal, 0);
        if (!allocation.IsCreated)
        {
            Vk.vkDestroyImage(device.Handle, handle, null);
            return null;
        }
        Vk.Check(Vk.vkBindImageMemory(device.Handle, handle, allocation.Block.Memory, allocation.Offset), "vkBindImageMemory");
        var image = new GpuImage(device, handle, allocation, create, isArray);
        image.MakeGeneral(device.Queue.Open());
        image.FillUndefined(device.Queue.Open());
        return image;
    }

    /// <summary>To draw into: one slice, or all with -1.</summary>
    internal ulong Attachment(GpuDevice device, int slice)
    {
        ref ulong view = ref m_attachments[slice < 0 ? Slices : slice];
        if (view == 0)
            view = slice < 0
                ? MakeView(device, VkImageViewType.Type2dArray, 0, Slices)
                : MakeView(device, VkImageViewType.Type2d, slice, 1);
        return view;
    }

    /// <summary>At once: nothing may still use it.</summary>
    internal void Destroy(GpuDevice device)
    {
        Vk.vkDestroyImageView(device.Handle, View, null);
        foreach (ulong view in m_attachments)
            Vk.vkDestroyImageView(device.Handle, view, null);
        Vk.vkDestroyImage(device.Handle, Handle, null);
        device.Memory.Free(m_allocation);
    }

    ulong MakeView(GpuDevice device, VkImageViewType type, int slice, int slices)
    {
        var create = new VkImageViewCreateInfo
        {
            sType = VkStructureType.ImageViewCreateInfo,
            image = Handle,
            viewType = type,
            format = Format,
            subresourceRange = Range(slice, slices),
        };
        ulong view;
        Vk.Check(Vk.vkCreateImageView(device.Handle, &create, null, &view), "vkCreateImageView");
        return view;
    }

    VkImageSubresourceRange Range(int slice, int slices) => new VkImageSubresourceRange
    {
        aspectMask = Aspect,
        levelCount = 1,
        baseArrayLayer = (uint)slice,
        layerCount = (uint)slices,
    };

    // What a fresh image holds is nobody's to count on: a colour that is seen, a depth that hides all.
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    void FillUndefined(GpuRecording recording)
    {
        VkImageSubresourceRange range = Range(0, Slices);
        if (IsDepth)
        {
            var near = new VkClearDepthStencilValue { depth = 1 };
            Vk.vkCmdClearDepthStencilImage(recording.Commands, Handle, VkImageLayout.General, &near, 1, &range);
            return;
        }
        VkClearColorValue magenta = default;
        magenta.float32[0] = magenta.float32[2] = magenta.float32[3] = 1;
        Vk.vkCmdClearColorImage(recording.Commands, Handle, VkImageLayout.General, &magenta, 1, &range);
    }

    void MakeGeneral(GpuRecording recording)
    {
        var barrier = new VkImageMemoryBarrier2
        {
            sType = VkStructureType.ImageMemoryBarrier2,
            dstStageMask = VkPipelineStageFlags2.AllCommands,
            dstAccessMask = VkAccessFlags2.MemoryRead | VkAccessFlags2.MemoryWrite,
            oldLayout = VkImageLayout.Undefined,
            newLayout = VkImageLayout.General,
            srcQueueFamilyIndex = uint.MaxValue,
            dstQueueFamilyIndex = uint.MaxValue,
            image = Handle,
            subresourceRange = Range(0, Slices),
        };
        var dependency = new VkDependencyInfo
        {
            sType = VkStructureType.DependencyInfo,
            imageMemoryBarrierCount = 1,
            pImageMemoryBarriers = &barrier,
        };
        Vk.vkCmdPipelineBarrier2(recording.Commands, &dependency);
    }
}
