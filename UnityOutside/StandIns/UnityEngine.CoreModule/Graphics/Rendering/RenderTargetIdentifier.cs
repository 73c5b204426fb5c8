namespace UnityEngine.Rendering;

/// <summary>A texture, or the name that a command buffer gave a temporary one.</summary>
public struct RenderTargetIdentifier : IEquatable<RenderTargetIdentifier>
{
    public const int AllDepthSlices = -1;

    BuiltinRenderTextureType m_type;
    // A name's number, or a texture's.
    int m_id;
    int m_slice;

    public RenderTargetIdentifier(BuiltinRenderTextureType type)
    {
        m_type = type;
        m_id = 0;
        m_slice = 0;
    }

    public RenderTargetIdentifier(int nameID)
    {
        m_type = BuiltinRenderTextureType.PropertyName;
        m_id = nameID;
        m_slice = 0;
    }

    public RenderTargetIdentifier(int nameID, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        : this(nameID)
    {
        m_slice = depthSlice;
    }

    public RenderTargetIdentifier(Texture tex)
    {
        m_type = tex is null ? BuiltinRenderTextureType.None : BuiltinRenderTextureType.RenderTexture;
        m_id = tex is null ? 0 : tex.Id;
        m_slice = 0;
    }

    public RenderTargetIdentifier(Texture tex, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        : this(tex)
    {
        m_slice = depthSlice;
    }

    public RenderTargetIdentifier(RenderTargetIdentifier renderTargetIdentifier, int mipLevel,
        CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
    {
        this = renderTargetIdentifier;
        m_slice = depthSlice;
    }

    internal readonly int Slice => m_slice;
    internal readonly bool IsNone => m_type == BuiltinRenderTextureType.None;
    internal readonly bool IsCameraTarget => m_type == BuiltinRenderTextureType.CameraTarget;
    internal readonly int NameId => m_type == BuiltinRenderTextureType.PropertyName ? m_id : -1; // The name, or -1.

    /// <summary>The texture itself; null for a name.</summary>
    internal readonly Texture Texture => m_type == BuiltinRenderTextureType.RenderTexture ? Texture.Find(m_id) : null;

    public static implicit operator RenderTargetIdentifier(BuiltinRenderTextureType type) => new RenderTargetIdentifier(type);
    public static implicit operator RenderTargetIdentifier(int nameID) => new RenderTargetIdentifier(nameID);
    public static implicit operator RenderTargetIdentifier(Texture tex) => new RenderTargetIdentifier(tex);
    public static bool operator ==(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => lhs.Equals(rhs);
    public static bool operator !=(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => !lhs.Equals(rhs);
    public bool Equals(RenderTargetIdentifier rhs) => m_type == rhs.m_type && m_id == rhs.m_id && m_slice == rhs.m_slice;
    public override bool Equals(object obj) => obj is RenderTargetIdentifier other && Equals(other);
    public override int GetHashCode() => HashCode.Combine(m_type, m_id, m_slice);

    public override string ToString() =>
        NameId >= 0 ? PropertyNames.NameOf(m_id) : Texture is { } texture ? texture.ToString() : m_type.ToString();
}
