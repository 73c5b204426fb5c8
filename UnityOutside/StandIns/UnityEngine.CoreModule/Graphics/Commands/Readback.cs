namespace StandIns.Graphics;

static unsafe class Readback
{
    internal static GpuBuffer Copy(GpuDevice device, GpuBuffer source, ulong offset, ulong bytes)
    {
        GpuBuffer copy = Create(device, bytes);
        GpuRecording recording = device.Queue.Open();
        recording.Barrier();
        recording.Copy(source, offset, copy, 0, bytes);
        return copy;
    }

    internal static GpuBuffer Copy(GpuDevice device, GpuImage source, int texelBytes)
    {
        GpuBuffer copy = Create(device, (ulong)source.Width * (ulong)source.Height * (ulong)source.Slices * (ulong)texelBytes);
        GpuRecording recording = device.Queue.Open();
        recording.Barrier();
        var region = new BufferImageCopy
        {
            ImageSubresource = new ImageSubresourceLayers { AspectMask = source.Aspect, LayerCount = (uint)source.Slices },
            ImageExtent = new Extent3D { Width = (uint)source.Width, Height = (uint)source.Height, Depth = 1 },
        };
        Api.CmdCopyImageToBuffer(recording.Commands, source.Handle, ImageLayout.General, copy.Handle, 1, &region);
        copy.LastUse = recording.Number;
        return copy;
    }

    static GpuBuffer Create(GpuDevice device, ulong bytes) =>
        GpuBuffer.TryCreate(device, bytes, 0, isForHost: true, isRead: true)
        ?? throw new OutOfMemoryException($"No graphics memory to read {bytes} bytes back");
}
