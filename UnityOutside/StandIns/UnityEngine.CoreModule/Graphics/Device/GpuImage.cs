namespace StandIns.Graphics;

sealed unsafe class GpuImage
{
    internal readonly Image Handle;
    internal readonly ImageView View;
    internal readonly Format Format;
    internal readonly int Width;
    internal readonly int Height;
    internal readonly int Slices;
    readonly GpuAllocation m_allocation;
    readonly ImageView[] m_attachments; // Of one slice each, made when first asked for, and of all slices as an attachment.

    GpuImage(GpuDevice device, Image handle, in GpuAllocation allocation, in ImageCreateInfo create, bool isArray)
    {
        Handle = handle;
        m_allocation = allocation;
        Format = create.Format;
        Width = (int)create.Extent.Width;
        Height = (int)create.Extent.Height;
        Slices = (int)create.ArrayLayers;
        View = MakeView(device, isArray ? ImageViewType.Type2DArray : ImageViewType.Type2D, 0, Slices);
        m_attachments = new ImageView[Slices + 1];
    }

    internal bool IsDepth => Format == Format.D32Sfloat;
    internal ImageAspectFlags Aspect => IsDepth ? ImageAspectFlags.DepthBit : ImageAspectFlags.ColorBit;

    /// <summary>An image, or null if there is no memory for it.</summary>
    internal static GpuImage TryCreate(GpuDevice device, Format format, (int Width, int Height) size, int slices,
        bool isArray, bool isWritten)
    {
        bool isDepth = format == Format.D32Sfloat;
        var create = new ImageCreateInfo(imageType: ImageType.Type2D, format: format,
            extent: new Extent3D { Width = (uint)size.Width, Height = (uint)size.Height, Depth = 1 }, mipLevels: 1,
            arrayLayers: (uint)slices, samples: SampleCountFlags.Count1Bit,
            usage: ImageUsageFlags.SampledBit | ImageUsageFlags.TransferSrcBit | ImageUsageFlags.TransferDstBit
                | (isDepth ? ImageUsageFlags.DepthStencilAttachmentBit : ImageUsageFlags.ColorAttachmentBit)
                | (isWritten ? ImageUsageFlags.StorageBit : 0),
            initialLayout: ImageLayout.Undefined);
        Image handle;
        Check(Api.CreateImage(device.Handle, &create, null, &handle), "vkCreateImage");
        MemoryRequirements needs;
        Api.GetImageMemoryRequirements(device.Handle, handle, &needs);
        GpuAllocation allocation = device.Memory.Allocate(needs, true, MemoryPropertyFlags.DeviceLocalBit, 0);
        if (!allocation.IsCreated)
        {
            Api.DestroyImage(device.Handle, handle, null);
            return null;
        }
        Check(Api.BindImageMemory(device.Handle, handle, allocation.Block.Memory, allocation.Offset), "vkBindImageMemory");
        var image = new GpuImage(device, handle, allocation, create, isArray);
        image.MakeGeneral(device.Queue.Open());
        image.FillUndefined(device.Queue.Open());
        return image;
    }

    /// <summary>To draw into: one slice, or all with -1.</summary>
    internal ImageView Attachment(GpuDevice device, int slice)
    {
        ref ImageView view = ref m_attachments[slice < 0 ? Slices : slice];
        if (view.Handle == 0)
            view = slice < 0
                ? MakeView(device, ImageViewType.Type2DArray, 0, Slices)
                : MakeView(device, ImageViewType.Type2D, slice, 1);
        return view;
    }

    /// <summary>At once: nothing may still use it.</summary>
    internal void Destroy(GpuDevice device)
    {
        Api.DestroyImageView(device.Handle, View, null);
        foreach (ImageView view in m_attachments)
            Api.DestroyImageView(device.Handle, view, null);
        Api.DestroyImage(device.Handle, Handle, null);
        device.Memory.Free(m_allocation);
    }

    ImageView MakeView(GpuDevice device, ImageViewType type, int slice, int slices)
    {
        var create = new ImageViewCreateInfo(image: Handle, viewType: type, format: Format,
            subresourceRange: Range(slice, slices));
        ImageView view;
        Check(Api.CreateImageView(device.Handle, &create, null, &view), "vkCreateImageView");
        return view;
    }

    ImageSubresourceRange Range(int slice, int slices) => new ImageSubresourceRange
    {
        AspectMask = Aspect,
        LevelCount = 1,
        BaseArrayLayer = (uint)slice,
        LayerCount = (uint)slices,
    };

    // What a fresh image holds is nobody's to count on: a colour that is seen, a depth that hides all.
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    void FillUndefined(GpuRecording recording)
    {
        ImageSubresourceRange range = Range(0, Slices);
        if (IsDepth)
        {
            var near = new ClearDepthStencilValue { Depth = 1 };
            Api.CmdClearDepthStencilImage(recording.Commands, Handle, ImageLayout.General, &near, 1, &range);
            return;
        }
        ClearColorValue magenta = default;
        magenta.Float32_0 = magenta.Float32_2 = magenta.Float32_3 = 1;
        Api.CmdClearColorImage(recording.Commands, Handle, ImageLayout.General, &magenta, 1, &range);
    }

    void MakeGeneral(GpuRecording recording)
    {
        var barrier = new ImageMemoryBarrier2(dstStageMask: PipelineStageFlags2.AllCommandsBit,
            dstAccessMask: AccessFlags2.MemoryReadBit | AccessFlags2.MemoryWriteBit, oldLayout: ImageLayout.Undefined,
            newLayout: ImageLayout.General, srcQueueFamilyIndex: uint.MaxValue, dstQueueFamilyIndex: uint.MaxValue,
            image: Handle, subresourceRange: Range(0, Slices));
        var dependency = new DependencyInfo(imageMemoryBarrierCount: 1, pImageMemoryBarriers: &barrier);
        Api.CmdPipelineBarrier2(recording.Commands, &dependency);
    }
}
