namespace StandIns.Graphics;

static unsafe class ReadbackTable
{
    static readonly Dictionary<int, ReadbackEntry> s_entries = new Dictionary<int, ReadbackEntry>();
    static readonly List<int> s_ids = new List<int>();
    static int s_last;

    internal static ReadbackEntry Find(int id) => s_entries.TryGetValue(id, out ReadbackEntry entry) ? entry : null;

    internal static AsyncGPUReadbackRequest Add(GraphicsBuffer source, int size, int offset,
        Action<AsyncGPUReadbackRequest> callback)
    {
        if (size < 0 || offset < 0 || (long)offset + size > source.Bytes)
            throw new ArgumentException($"{source.Label}: {size} bytes at {offset} are not within its {source.Bytes}");
        GpuBuffer copy = Readback.Copy(GpuDevice.Current, source.ForDevice(), (ulong)offset, (ulong)size);
        return Add(new ReadbackEntry(copy, size, 1, 1, size, callback));
    }

    internal static AsyncGPUReadbackRequest Add(Texture source, Action<AsyncGPUReadbackRequest> callback)
    {
        GpuImage image = source.ImageFor(isDepth: false);
        int texel = TextureFormats.TexelBytes(image.Format);
        GpuBuffer copy = Readback.Copy(GpuDevice.Current, image, texel);
        return Add(new ReadbackEntry(copy, image.Width, image.Height, image.Slices, image.Width * image.Height * texel,
            callback));
    }

    internal static NativeArray<T> Data<T>(int id, int layer) where T : struct
    {
        ReadbackEntry entry = Find(id)
            ?? throw new InvalidOperationException("The data of this readback is gone: its frame has ended");
        if (!entry.IsDone)
            throw new InvalidOperationException("The readback is not done");
        if ((uint)layer >= (uint)entry.Layers)
            throw new ArgumentException($"Layer {layer} of {entry.Layers}");
        return entry.Data<T>(layer);
    }

    internal static void EndFrame()
    {
        for (int i = s_ids.Count - 1; i >= 0; i--)
        {
            ReadbackEntry entry = Find(s_ids[i]);
            if (!entry.IsDone)
            {
                entry.Poll();
                continue;
            }
            entry.Dispose();
            s_entries.Remove(s_ids[i]);
            s_ids.RemoveAt(i);
        }
    }

    static AsyncGPUReadbackRequest Add(ReadbackEntry entry)
    {
        s_last++;
        entry.Id = s_last;
        s_entries.Add(s_last, entry);
        s_ids.Add(s_last);
        return new AsyncGPUReadbackRequest(s_last);
    }
}
