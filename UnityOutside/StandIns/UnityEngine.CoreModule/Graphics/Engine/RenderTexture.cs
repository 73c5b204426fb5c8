namespace UnityEngine;

/// <summary>A colour or depth image to draw into, or both; its first row is the picture's lowest, as Unity has it with every API.
/// It is made when it is first used.</summary>
public class RenderTexture : Texture
{
    RenderTextureDescriptor m_descriptor;
    GpuImage m_color;
    GpuImage m_depth;

    public RenderTexture(RenderTextureDescriptor desc)
    {
        if (desc.width <= 0 || desc.height <= 0 || desc.volumeDepth <= 0)
            throw new ArgumentException($"A render texture of {desc.width} x {desc.height} x {desc.volumeDepth}");
        if (desc.msaaSamples > 1 || desc.useMipMap)
            throw new NotSupportedException("Render textures with several samples or mip levels");
        m_descriptor = desc;
        wrapMode = TextureWrapMode.Clamp;
    }

    public RenderTexture(int width, int height, int depth) : this(width, height, depth, RenderTextureFormat.Default) { }

    public RenderTexture(int width, int height, int depth, RenderTextureFormat format)
        : this(width, height, depth, format, RenderTextureReadWrite.Default) { }

    public RenderTexture(int width, int height, int depth, RenderTextureFormat format, RenderTextureReadWrite readWrite)
        : this(new RenderTextureDescriptor(width, height, TextureFormats.Of(format, readWrite),
            TextureFormats.DepthOf(format == RenderTextureFormat.Depth ? Math.Max(depth, 32) : depth)))
    {
    }

    public RenderTexture(int width, int height, int depth, GraphicsFormat format)
        : this(new RenderTextureDescriptor(width, height, format, depth)) { }

    public RenderTexture(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat)
        : this(new RenderTextureDescriptor(width, height, colorFormat, depthStencilFormat)) { }

    internal bool IsScreen { get; set; }

    public override int width
    {
        get => m_descriptor.width;
        set => Change().width = value;
    }

    public override int height
    {
        get => m_descriptor.height;
        set => Change().height = value;
    }

    public override TextureDimension dimension
    {
        get => m_descriptor.dimension;
        set => Change().dimension = value;
    }

    public int volumeDepth
    {
        get => m_descriptor.volumeDepth;
        set => Change().volumeDepth = value;
    }

    public bool enableRandomWrite
    {
        get => m_descriptor.enableRandomWrite;
        set => Change().enableRandomWrite = value;
    }

    public GraphicsFormat graphicsFormat
    {
        get => m_descriptor.graphicsFormat;
        set => Change().graphicsFormat = value;
    }

    public GraphicsFormat depthStencilFormat
    {
        get => m_descriptor.depthStencilFormat;
        set => Change().depthStencilFormat = value;
    }

    public bool sRGB => m_descriptor.sRGB;

    public RenderTextureDescriptor descriptor
    {
        get => m_descriptor;
        set => Change() = value;
    }

    /// <summary>False, with an error logged, where there is no memory for it.</summary>
    public bool Create()
    {
        if (IsCreated())
            return true;
        CheckAlive();
        GpuDevice device = GpuDevice.Current;
        bool isArray = dimension == TextureDimension.Tex2DArray;
        bool hasColor = graphicsFormat != GraphicsFormat.None;
        if (hasColor && sRGB && enableRandomWrite)
            throw new ArgumentException($"{name}: an sRGB texture cannot be written at random");
        if (hasColor)
            m_color = GpuImage.TryCreate(device, TextureFormats.Vulkan(graphicsFormat), (width, height), volumeDepth, isArray,
                enableRandomWrite);
        if (depthStencilFormat != GraphicsFormat.None)
            m_depth =
                GpuImage.TryCreate(device, TextureFormats.Vulkan(depthStencilFormat), (width, height), volumeDepth, isArray,
                isWritten: false);
        if (hasColor == (m_color != null) && depthStencilFormat != GraphicsFormat.None == (m_depth != null))
            return true;
        Release();
        Debug.LogError($"Out of graphics memory: render texture {name} of {width} x {height} could not be made");
        return false;
    }

    public bool IsCreated() => m_color != null || m_depth != null;

    /// <summary>Gives its memory back; used again, it is made anew.</summary>
    public void Release()
    {
        Retire(ref m_color);
        Retire(ref m_depth);
    }

    internal override GraphicsFormat Format => m_descriptor.graphicsFormat;
    internal ref readonly RenderTextureDescriptor Descriptor => ref m_descriptor;
    internal GpuImage Color => m_color;
    internal GpuImage Depth => m_depth;

    internal override GpuImage ImageFor(bool isDepth)
    {
        if (!Create())
            throw new InvalidOperationException($"Render texture {name} could not be made");
        return isDepth || m_color == null ? m_depth : m_color;
    }

    internal override void OnDestroyed()
    {
        Release();
        base.OnDestroyed();
    }

    void CheckAlive()
    {
        if (IsDestroyed)
            throw new InvalidOperationException($"Render texture {name} is used after it was destroyed");
    }

    ref RenderTextureDescriptor Change()
    {
        if (IsCreated())
            throw new InvalidOperationException($"Render texture {name} is there already: it cannot be changed until it is "
                + $"released");
        return ref m_descriptor;
    }

    static void Retire(ref GpuImage image)
    {
        if (image != null)
            GpuDevice.Current.Queue.Retire(image);
        image = null;
    }
}
