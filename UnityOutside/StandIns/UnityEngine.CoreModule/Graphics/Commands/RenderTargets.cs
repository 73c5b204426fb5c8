namespace StandIns.Graphics;

sealed unsafe class RenderTargets(GpuDevice device)
{
    internal const int MaxColors = 4;

    readonly GpuDevice m_device = device;
    readonly GpuImage[] m_colors = new GpuImage[MaxColors];
    int m_colorCount;
    GpuImage m_depth;
    int m_slice;
    bool m_isOpen;

    internal bool IsSet => m_colorCount > 0 || m_depth != null;
    internal int ColorCount => m_colorCount;
    internal VkFormat DepthFormat => m_depth?.Format ?? VkFormat.Undefined;
    int Width => (m_depth ?? m_colors[0]).Width;
    int Height => (m_depth ?? m_colors[0]).Height;
    uint Layers => m_slice >= 0 ? 1 : (uint)(m_depth ?? m_colors[0]).Slices;

    internal VkFormat ColorFormat(int index) => m_colors[index].Format;

    internal void Begin(int slice)
    {
        m_colorCount = 0;
        m_depth = null;
        m_slice = slice;
    }

    internal void AddColor(GpuImage image)
    {
        if (m_colorCount == MaxColors)
            throw new NotSupportedException($"More than {MaxColors} colour targets");
        m_colors[m_colorCount++] = image;
    }

    internal void SetDepth(GpuImage image) => m_depth = image;

    internal Vector4 Complete()
    {
        for (int i = 0; i < m_colorCount; i++)
            if (m_colors[i].Width != Width || m_colors[i].Height != Height)
                throw new InvalidOperationException($"Targets of different sizes: {m_colors[i].Width} x {m_colors[i].Height} "
                    + $"and "
                    + $"{Width} x {Height}");
        return new Vector4(0, 0, Width, Height);
    }

    internal void Reset()
    {
        Begin(0);
        Array.Clear(m_colors, 0, MaxColors);
    }

    internal void Open(GpuRecording recording)
    {
        if (m_isOpen)
            return;
        m_isOpen = true;
        recording.Barrier();
        VkRenderingAttachmentInfo* colors = stackalloc VkRenderingAttachmentInfo[MaxColors];
        for (int i = 0; i < m_colorCount; i++)
            colors[i] = Attachment(m_colors[i]);
        VkRenderingAttachmentInfo depth = default;
        if (m_depth != null)
            depth = Attachment(m_depth);
        var info = new VkRenderingInfo
        {
            sType = VkStructureType.RenderingInfo,
            renderArea = Area,
            layerCount = Layers,
            colorAttachmentCount = (uint)m_colorCount,
            pColorAttachments = colors,
            pDepthAttachment = m_depth == null ? null : &depth,
        };
        Vk.vkCmdBeginRendering(recording.Commands, &info);
    }

    internal void Close(GpuRecording recording)
    {
        if (m_isOpen)
            Vk.vkCmdEndRendering(recording.Commands);
        m_isOpen = false;
    }

    /// <param name="depth">As Unity has it: 1 is far.</param>
    internal void Clear(GpuRecording recording, bool clearColor, bool clearDepth, Vector4 color, float depth)
    {
        Open(recording);
        VkClearAttachment* cleared = stackalloc VkClearAttachment[MaxColors + 1];
        uint count = 0;
        for (int i = 0; clearColor && i < m_colorCount; i++)
        {
            VkClearAttachment attachment =
                new VkClearAttachment { aspectMask = VkImageAspectFlags.Color, colorAttachment = (uint)i };
            for (int c = 0; c < 4; c++)
                SetClear(ref attachment.clearValue.color, m_colors[i].Format, c, color[c]);
            cleared[count++] = attachment;
        }
        if (clearDepth && m_depth != null)
            cleared[count++] = new VkClearAttachment
            {
                aspectMask = VkImageAspectFlags.Depth,
                clearValue = new VkClearValue { depthStencil = new VkClearDepthStencilValue { depth = 1 - depth } },
            };
        var rect = new VkClearRect { rect = Area, layerCount = Layers };
        if (count > 0)
            Vk.vkCmdClearAttachments(recording.Commands, count, cleared, 1, &rect);
    }

    /// <summary>Direct3D's direction of Y: up, the first row of the target being the one at the top.</summary>
    internal void SetViewport(GpuRecording recording, Vector4 rect)
    {
        var viewport = new VkViewport
        {
            x = rect.x,
            y = rect.y + rect.w,
            width = rect.z,
            height = -rect.w,
            maxDepth = 1,
        };
        Vk.vkCmdSetViewport(recording.Commands, 0, 1, &viewport);
        VkRect2D scissor = Area;
        Vk.vkCmdSetScissor(recording.Commands, 0, 1, &scissor);
    }

    VkRect2D Area => new VkRect2D { extent = new VkExtent2D { width = (uint)Width, height = (uint)Height } };

    static void SetClear(ref VkClearColorValue value, VkFormat format, int component, float color)
    {
        if (format == VkFormat.R32Uint || format == VkFormat.R32Sint || format == VkFormat.R32g32b32a32Uint)
            value.uint32[component] = unchecked((uint)(long)color);
        else
            value.float32[component] = color;
    }

    VkRenderingAttachmentInfo Attachment(GpuImage image) => new VkRenderingAttachmentInfo
    {
        sType = VkStructureType.RenderingAttachmentInfo,
        imageView = image.Attachment(m_device, m_slice),
        imageLayout = VkImageLayout.General,
        loadOp = VkAttachmentLoadOp.Load,
    };
}
