namespace UnityEngine;

public struct RenderTextureDescriptor
{
    public RenderTextureDescriptor(int width, int height) : this(width, height, RenderTextureFormat.Default, 0) { }

    public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat) : this(width, height, colorFormat, 0)
    {
    }

    public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits)
        : this(width, height, TextureFormats.Of(colorFormat, RenderTextureReadWrite.Linear), depthBufferBits) { }

    public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits)
        : this(width, height, colorFormat, TextureFormats.DepthOf(depthBufferBits)) { }

    public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat)
    {
        this.width = width;
        this.height = height;
        graphicsFormat = colorFormat;
        this.depthStencilFormat = depthStencilFormat;
        dimension = TextureDimension.Tex2D;
        volumeDepth = 1;
        msaaSamples = 1;
        enableRandomWrite = false;
        useMipMap = false;
    }

    public int width { get; set; }
    public int height { get; set; }
    public int volumeDepth { get; set; }
    public int msaaSamples { get; set; }
    public GraphicsFormat graphicsFormat { get; set; }
    public GraphicsFormat depthStencilFormat { get; set; }
    public TextureDimension dimension { get; set; }
    public bool enableRandomWrite { get; set; }
    public bool useMipMap { get; set; }

    public bool sRGB
    {
        readonly get => graphicsFormat == GraphicsFormat.R8G8B8A8_SRGB;
        set
        {
            if (sRGB || graphicsFormat == GraphicsFormat.R8G8B8A8_UNorm)
                graphicsFormat = value ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
        }
    }

    internal readonly bool IsSameAs(in RenderTextureDescriptor other) => width == other.width && height == other.height
        && volumeDepth == other.volumeDepth && graphicsFormat == other.graphicsFormat && dimension == other.dimension
        && depthStencilFormat == other.depthStencilFormat && enableRandomWrite == other.enableRandomWrite;
}
