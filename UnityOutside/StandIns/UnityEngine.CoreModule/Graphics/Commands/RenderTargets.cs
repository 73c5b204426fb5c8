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
    internal Format DepthFormat => m_depth?.Format ?? Format.Undefined;
    int Width => (m_depth ?? m_colors[0]).Width;
    int Height => (m_depth ?? m_colors[0]).Height;
    uint Layers => m_slice >= 0 ? 1 : (uint)(m_depth ?? m_colors[0]).Slices;

    internal Format ColorFormat(int index) => m_colors[index].Format;

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
        RenderingAttachmentInfo* colors = stackalloc RenderingAttachmentInfo[MaxColors];
        for (int i = 0; i < m_colorCount; i++)
            colors[i] = Attachment(m_colors[i]);
        RenderingAttachmentInfo depth = default;
        if (m_depth != null)
            depth = Attachment(m_depth);
        var info = new RenderingInfo(renderArea: Area, layerCount: Layers, colorAttachmentCount: (uint)m_colorCount,
            pColorAttachments: colors, pDepthAttachment: m_depth == null ? null : &depth);
        Api.CmdBeginRendering(recording.Commands, &info);
    }

    internal void Close(GpuRecording recording)
    {
        if (m_isOpen)
            Api.CmdEndRendering(recording.Commands);
        m_isOpen = false;
    }

    /// <param name="depth">As Unity has it: 1 is far.</param>
    internal void Clear(GpuRecording recording, bool clearColor, bool clearDepth, Vector4 color, float depth)
    {
        Open(recording);
        ClearAttachment* cleared = stackalloc ClearAttachment[MaxColors + 1];
        uint count = 0;
        for (int i = 0; clearColor && i < m_colorCount; i++)
        {
            ClearAttachment attachment =
                new ClearAttachment { AspectMask = ImageAspectFlags.ColorBit, ColorAttachment = (uint)i };
            attachment.ClearValue.Color = ClearColor(m_colors[i].Format, color);
            cleared[count++] = attachment;
        }
        if (clearDepth && m_depth != null)
            cleared[count++] = new ClearAttachment
            {
                AspectMask = ImageAspectFlags.DepthBit,
                ClearValue = new ClearValue { DepthStencil = new ClearDepthStencilValue { Depth = 1 - depth } },
            };
        var rect = new ClearRect { Rect = Area, LayerCount = Layers };
        if (count > 0)
            Api.CmdClearAttachments(recording.Commands, count, cleared, 1, &rect);
    }

    /// <summary>Direct3D's direction of Y: up, the first row of the target being the one at the top.</summary>
    internal void SetViewport(GpuRecording recording, Vector4 rect)
    {
        var viewport = new Viewport
        {
            X = rect.x,
            Y = rect.y + rect.w,
            Width = rect.z,
            Height = -rect.w,
            MaxDepth = 1,
        };
        Api.CmdSetViewport(recording.Commands, 0, 1, &viewport);
        Rect2D scissor = Area;
        Api.CmdSetScissor(recording.Commands, 0, 1, &scissor);
    }

    Rect2D Area => new Rect2D { Extent = new Extent2D { Width = (uint)Width, Height = (uint)Height } };

    static ClearColorValue ClearColor(Format format, Vector4 color)
    {
        uint Whole(float value) => unchecked((uint)(long)value);
        return format == Format.R32Uint || format == Format.R32Sint || format == Format.R32G32B32A32Uint
            ? new ClearColorValue(null, null, null, null, null, null, null, null,
                Whole(color.x), Whole(color.y), Whole(color.z), Whole(color.w))
            : new ClearColorValue(color.x, color.y, color.z, color.w);
    }

    RenderingAttachmentInfo Attachment(GpuImage image) => new RenderingAttachmentInfo(
        imageView: image.Attachment(m_device, m_slice), imageLayout: ImageLayout.General, loadOp: AttachmentLoadOp.Load);
}
