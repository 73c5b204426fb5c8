namespace UnityEngine.Rendering;

// Upload: X is the buffer, A where it begins, B how many elements, C of how many bytes; Data where the bytes are.
public unsafe partial class CommandBuffer
{
    public void SetBufferData(GraphicsBuffer buffer, Array data) => SetBufferData(buffer, data, 0, 0, data.Length);

    /// <summary>Copies the data now; the device gets it when the command is done.</summary>
    public void SetBufferData(GraphicsBuffer buffer, Array data, int managedBufferStartIndex, int graphicsBufferStartIndex,
        int count)
    {
        int size = GraphicsBuffer.ElementSize(data);
        GraphicsBuffer.CheckSource(managedBufferStartIndex, count, data.Length);
        GCHandle pin = GCHandle.Alloc(data, GCHandleType.Pinned);
        byte* first = (byte*)pin.AddrOfPinnedObject() + (long)managedBufferStartIndex * size;
        AddUpload(buffer, first, graphicsBufferStartIndex, count, size);
        pin.Free();
    }

    public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data) where T : struct =>
        SetBufferData(buffer, data, 0, 0, data.Length);

    public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data, int nativeBufferStartIndex,
        int graphicsBufferStartIndex,
        int count) where T : struct
    {
        int size = UnsafeUtility.SizeOf<T>();
        GraphicsBuffer.CheckSource(nativeBufferStartIndex, count, data.Length);
        byte* first = (byte*)data.GetUnsafeReadOnlyPtr() + (long)nativeBufferStartIndex * size;
        AddUpload(buffer, first, graphicsBufferStartIndex, count, size);
    }

    /// <summary>All of one buffer into another of the same size.</summary>
    public void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest)
    {
        if ((source.target & GraphicsBuffer.Target.CopySource) == 0)
            throw new ArgumentException($"{source.Label} was not made with Target.CopySource", nameof(source));
        if ((dest.target & GraphicsBuffer.Target.CopyDestination) == 0)
            throw new ArgumentException($"{dest.Label} was not made with Target.CopyDestination", nameof(dest));
        if (source.Bytes != dest.Bytes)
            throw new ArgumentException($"{source.Label} has {source.Bytes} bytes, {dest.Label} {dest.Bytes}", nameof(dest));
        Add(new RecordedCommand { Kind = CommandKind.CopyBuffer, X = source, Y = dest });
    }

    /// <summary>Has passed when the device has done all commands before it.</summary>
    public GraphicsFence CreateGraphicsFence(GraphicsFenceType fenceType, SynchronisationStageFlags stage)
    {
        GraphicsFence fence = GraphicsFence.Create(fenceType);
        Add(new RecordedCommand { Kind = CommandKind.Fence, A = fence.Id });
        return fence;
    }

    void AddUpload(GraphicsBuffer buffer, byte* data, int start, int count, int size)
    {
        if (buffer == null)
            throw new ArgumentNullException(nameof(buffer));
        Add(new RecordedCommand
        {
            Kind = CommandKind.Upload,
            X = buffer,
            A = start,
            B = count,
            C = size,
            Data = AddBytes(data, (long)count * size),
        });
    }
}
