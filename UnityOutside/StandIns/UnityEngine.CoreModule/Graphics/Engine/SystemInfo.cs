namespace UnityEngine;

/// <summary>What the device can; with none, as on a server without graphics: nothing.</summary>
public sealed class SystemInfo
{
    public static string graphicsDeviceName => GpuDevice.TryGet(out _)?.Name ?? "Null Device";
    public static GraphicsDeviceType graphicsDeviceType => HasDevice ? GraphicsDeviceType.Vulkan : GraphicsDeviceType.Null;
    public static bool supportsComputeShaders => HasDevice && !HeadlessGraphics.HasNoCompute;

    /// <summary>Storage buffers of a vertex shader.</summary>
    public static int maxComputeBufferInputsVertex =>
        HeadlessGraphics.VertexBuffers ?? (int)(GpuDevice.TryGet(out _)?.Limits.MaxPerStageDescriptorStorageBuffers ?? 0);

    public static bool supportsGraphicsFence => HasDevice && !HeadlessGraphics.HasNoFences;
    public static bool supportsRenderTargetArrayIndexFromVertexShader => GpuDevice.TryGet(out _)?.ChoosesSlices ?? false;

    /// <summary>Not by this host: its render passes have no view masks.</summary>
    public static bool supportsMultiview => false;

    public static bool graphicsUVStartsAtTop => true;

    /// <summary>In bytes: what one shader may see of a buffer.</summary>
    public static long maxGraphicsBufferSize =>
        HasDevice && GpuDevice.TryGet(out _) is { } device ? device.Limits.MaxStorageBufferRange : 0;

    public static bool IsFormatSupported(GraphicsFormat format, GraphicsFormatUsage usage) => usage switch
    {
        GraphicsFormatUsage.Blend => GpuDevice.TryGet(out _)?.CanBlend(TextureFormats.Vulkan(format)) ?? false,
        _ => throw new System.NotSupportedException("GraphicsFormatUsage." + usage),
    };

    static bool HasDevice => !IsServer && GpuDevice.TryGet(out _) != null;

    internal static bool IsServer { get; set; } // Whether this process has no graphics, whatever the machine has.
}
