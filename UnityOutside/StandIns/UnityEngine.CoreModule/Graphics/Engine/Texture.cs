namespace UnityEngine;

public class Texture : Object
{
    // A RenderTargetIdentifier is a plain struct and names a texture by its number.
    static readonly Dictionary<int, Texture> s_textures = new Dictionary<int, Texture>();

    protected Texture()
    {
        lock (s_textures)
            s_textures.Add(Id, this);
    }

    public virtual int width { get; set; }
    public virtual int height { get; set; }
    public virtual TextureDimension dimension { get; set; } = TextureDimension.Tex2D;
    public FilterMode filterMode { get; set; } = FilterMode.Bilinear;
    public TextureWrapMode wrapMode { get; set; } = TextureWrapMode.Repeat;
    internal virtual GraphicsFormat Format => GraphicsFormat.None; // RenderTexture hides graphicsFormat with one that can be set.

    internal static Texture Find(int id)
    {
        lock (s_textures)
            return s_textures.TryGetValue(id, out Texture texture) ? texture : null;
    }

    internal virtual GpuImage ImageFor(bool isDepth) => throw new System.NotSupportedException(GetType().Name);

    internal override void OnDestroyed()
    {
        lock (s_textures)
            s_textures.Remove(Id);
    }
}
