namespace UnityEngine;

public sealed unsafe partial class GraphicsBuffer
{
    const ulong FlushBytes = 16 << 20; // So much is recorded before it is sent on its way.

    /// <summary>Copies the data on its way to the device; all indices and counts are of elements of the array.</summary>
    public void SetData(Array data) => SetData(data, 0, 0, data.Length);

    public void SetData(Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
    {
        int size = ElementSize(data);
        CheckSource(managedBufferStartIndex, count, data.Length);
        GCHandle pin = GCHandle.Alloc(data, GCHandleType.Pinned);
        try
        {
            byte* first = (byte*)pin.AddrOfPinnedObject() + (long)managedBufferStartIndex * size;
            Upload(first, graphicsBufferStartIndex, count, size);
        }
        finally
        {
            pin.Free();
        }
    }

    public void SetData<T>(NativeArray<T> data) where T : struct => SetData(data, 0, 0, data.Length);

    public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count) where T
        : struct
    {
        int size = UnsafeUtility.SizeOf<T>();
        CheckSource(nativeBufferStartIndex, count, data.Length);
        byte* first = (byte*)data.GetUnsafeReadOnlyPtr() + (long)nativeBufferStartIndex * size;
        Upload(first, graphicsBufferStartIndex, count, size);
    }

    /// <summary>Waits until the device has done all that was asked of it, then copies.</summary>
    public void GetData(Array data) => GetData(data, 0, 0, data.Length);

    public void GetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count)
    {
        int size = ElementSize(data);
        CheckSource(managedBufferStartIndex, count, data.Length);
        CheckRange(computeBufferStartIndex, count, size);
        ulong bytes = (ulong)count * (ulong)size;
        if (bytes == 0)
            return;
        GpuDevice device = GpuDevice.Current;
        GpuBuffer copy = Readback.Copy(device, ForDevice(), (ulong)computeBufferStartIndex * (ulong)size, bytes);
        device.Queue.Await(copy.LastUse);
        GCHandle pin = GCHandle.Alloc(data, GCHandleType.Pinned);
        UnsafeUtility.MemCpy((byte*)pin.AddrOfPinnedObject() + (long)managedBufferStartIndex * size, copy.Mapped, (long)bytes);
        pin.Free();
        copy.Destroy(device);
    }

    internal void Record(GpuRecording recording, byte* data, int start, int count, int size)
    {
        CheckRange(start, count, size);
        GpuBuffer target = ForDevice();
        ulong bytes = (ulong)count * (ulong)size;
        if (bytes == 0)
            return;
        byte* written = recording.Uploads.Take(bytes, out GpuBuffer source, out ulong offset);
        UnsafeUtility.MemCpy(written, data, (long)bytes);
        recording.Barrier();
        recording.Copy(source, offset, target, (ulong)start * (ulong)size, bytes);
    }

    void Upload(byte* data, int start, int count, int size)
    {
        GpuQueue queue = GpuDevice.Current.Queue;
        GpuRecording recording = queue.Open();
        Record(recording, data, start, count, size);
        if (recording.Uploads.Bytes > FlushBytes)
            queue.Flush();
    }

    internal static int ElementSize(Array data)
    {
        if (data == null)
            throw new ArgumentNullException(nameof(data));
        return Marshal.SizeOf(data.GetType().GetElementType());
    }

    internal static void CheckSource(int start, int count, int length)
    {
        if (start < 0 || count < 0 || (long)start + count > length)
            throw new ArgumentOutOfRangeException(nameof(count),
                $"elements {start} to {(long)start + count} of an array of {length}");
    }
}
