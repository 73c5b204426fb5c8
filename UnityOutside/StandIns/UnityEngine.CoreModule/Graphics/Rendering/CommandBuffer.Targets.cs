namespace UnityEngine.Rendering;

// SetTarget: A colours from Data on and then one depth; B is the slice, or -1 for all.
public partial class CommandBuffer
{
    public void SetRenderTarget(RenderTargetIdentifier rt) => SetRenderTarget(rt, rt, 0, CubemapFace.Unknown, rt.Slice);

    public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace, int depthSlice) =>
        SetRenderTarget(rt, rt, mipLevel, cubemapFace, depthSlice);

    public void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction loadAction,
        RenderBufferStoreAction storeAction) => SetRenderTarget(rt);

    public void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction colorLoadAction,
        RenderBufferStoreAction colorStoreAction, RenderBufferLoadAction depthLoadAction,
            RenderBufferStoreAction depthStoreAction) => SetRenderTarget(rt);

    public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth) =>
        SetRenderTarget(color, depth, 0, CubemapFace.Unknown, color.Slice);

    public void SetRenderTarget(RenderTargetIdentifier color, RenderBufferLoadAction colorLoadAction,
        RenderBufferStoreAction colorStoreAction, RenderTargetIdentifier depth, RenderBufferLoadAction depthLoadAction,
        RenderBufferStoreAction depthStoreAction) => SetRenderTarget(color, depth);

    public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel,
        CubemapFace cubemapFace,
        int depthSlice)
    {
        int first = AddTarget(color);
        AddTarget(depth);
        Add(new RecordedCommand { Kind = CommandKind.SetTarget, A = 1, B = depthSlice, Data = first });
    }

    public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth) =>
        SetRenderTarget(colors, depth, 0, CubemapFace.Unknown, colors[0].Slice);

    public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth, int mipLevel,
        CubemapFace cubemapFace,
        int depthSlice)
    {
        int first = Targets.Count;
        Targets.AddRange(colors);
        AddTarget(depth);
        Add(new RecordedCommand { Kind = CommandKind.SetTarget, A = colors.Length, B = depthSlice, Data = first });
    }

    public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor) =>
        ClearRenderTarget(clearDepth, clearColor, backgroundColor, 1f);

    /// <summary>A depth of 1 is far away, whatever the device's own order is.</summary>
    public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor, float depth) =>
        ClearRenderTarget((clearDepth ? RTClearFlags.Depth : 0) | (clearColor ? RTClearFlags.Color : 0), backgroundColor, depth);

    public void ClearRenderTarget(RTClearFlags clearFlags, Color backgroundColor, float depth = 1f, uint stencil = 0)
    {
        int first = AddValue(PropertyValue.Of((Vector4)backgroundColor));
        AddValue(PropertyValue.Of(depth));
        Add(new RecordedCommand { Kind = CommandKind.ClearTarget, A = (int)clearFlags, Data = first });
    }

    public void SetViewport(Rect pixelRect) => Add(new RecordedCommand
    {
        Kind = CommandKind.SetViewport,
        Data = AddValue(PropertyValue.Of(new Vector4(pixelRect.x, pixelRect.y, pixelRect.width, pixelRect.height))),
    });

    /// <summary>Gives a texture of its own the name, for shaders and as a target, until it is released.</summary>
    public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc) => GetTemporaryRT(nameID, desc, FilterMode.Point);

    public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc, FilterMode filter)
    {
        Descriptors.Add(desc);
        Add(new RecordedCommand
        {
            Kind = CommandKind.GetTemporary,
            A = nameID,
            B = (int)filter,
            Data = Descriptors.Count - 1
        });
    }

    public void ReleaseTemporaryRT(int nameID) => Add(new RecordedCommand { Kind = CommandKind.ReleaseTemporary, A = nameID });
}
