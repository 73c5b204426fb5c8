namespace UnityEngine.Rendering;

public class RTHandle
{
    internal RenderTexture Texture;

    public RenderTexture rt => Texture;

    public static implicit operator RenderTargetIdentifier(RTHandle handle) => new RenderTargetIdentifier(handle.Texture);
}
