namespace UnityEngine.Rendering;

public static class AsyncGPUReadback
{
    public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, Action<AsyncGPUReadbackRequest> callback = null) =>
        Request(src, (int)src.Bytes, 0, callback);

    /// <summary>Size and offset are in bytes.</summary>
    public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, int size, int offset,
        Action<AsyncGPUReadbackRequest> callback = null) => ReadbackTable.Add(src, size, offset, callback);

    /// <summary>Texels in their own format, the lowest row first.</summary>
    public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex = 0,
        Action<AsyncGPUReadbackRequest> callback = null) => ReadbackTable.Add(src, callback);
}
