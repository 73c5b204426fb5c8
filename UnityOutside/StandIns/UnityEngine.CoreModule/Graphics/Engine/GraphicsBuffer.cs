namespace UnityEngine;

/// <summary>Memory of the device. One made with LockBufferForWrite lies where the host sees it, any other where only the device
/// does.</summary>
public sealed partial class GraphicsBuffer : IDisposable
{
    GpuBuffer m_buffer;

    public GraphicsBuffer(Target target, int count, int stride) : this(target, UsageFlags.None, count, stride) { }

    /// <summary>Where there is no memory for it, an error is logged and <see cref="IsValid"/> is false.</summary>
    /// <exception cref="ArgumentException">No elements, a stride that is not a multiple of 4, more bytes than
    /// SystemInfo.maxGraphicsBufferSize, no compute shaders for a target that takes them, or a buffer to lock that is copied
    /// into.</exception>
    public GraphicsBuffer(Target target, UsageFlags usageFlags, int count, int stride)
    {
        const Target anyStride = Target.Vertex | Target.CopySource | Target.CopyDestination;
        const Target computed = Target.Structured | Target.Raw | Target.Append | Target.Counter | Target.IndirectArguments;
        if ((target & computed) != 0 && !SystemInfo.supportsComputeShaders)
            throw new ArgumentException($"A graphics buffer of target {target} takes compute shaders, which are not there");
        if (count <= 0)
            throw new ArgumentException("A graphics buffer needs at least one element", nameof(count));
        if (stride <= 0)
            throw new ArgumentException("The stride of a graphics buffer is at least one byte", nameof(stride));
        if ((target & Target.Index) != 0 && stride != 2 && stride != 4)
            throw new ArgumentException("An index buffer's stride is 2 or 4 bytes", nameof(stride));
        if ((target & Target.Index) == 0 && (target & ~anyStride) != 0 && stride % 4 != 0)
            throw new ArgumentException("The stride must be a multiple of 4 bytes", nameof(stride));
        long bytes = (long)count * stride;
        if (bytes > SystemInfo.maxGraphicsBufferSize)
            throw new ArgumentException($"{bytes} bytes are more than SystemInfo.maxGraphicsBufferSize, "
                + SystemInfo.maxGraphicsBufferSize);
        if ((usageFlags & UsageFlags.LockBufferForWrite) != 0 && (target & Target.CopyDestination) != 0)
            throw new ArgumentException("A buffer that is locked for writing is only read by the GPU: nothing can be copied "
                + "into it");
        this.target = target;
        this.usageFlags = usageFlags;
        this.count = count;
        this.stride = stride;
        bool isLockable = (usageFlags & UsageFlags.LockBufferForWrite) != 0;
        m_buffer = GpuBuffer.TryCreate(GpuDevice.Current, (ulong)bytes, UsageOf(target), isLockable);
        if (m_buffer == null)
            Debug.LogError($"Out of graphics memory: a buffer of {bytes} bytes could not be made");
        else
            FillUndefined();
    }

    public int count { get; }
    public int stride { get; }
    public Target target { get; }
    public UsageFlags usageFlags { get; }
    public string name { private get; set; }
    internal long Bytes => (long)count * stride;
    internal string Label => string.IsNullOrEmpty(name) ? $"GraphicsBuffer ({target})" : name;

    public bool IsValid() => m_buffer != null;

    public void Dispose()
    {
        if (m_buffer == null)
            return;
        EndLock();
        GpuDevice.Current.Queue.Retire(m_buffer);
        m_buffer = null;
    }

    internal GpuBuffer ForDevice()
    {
        CheckValid();
        if (IsLocked)
            throw new InvalidOperationException($"{Label} is used by the GPU while it is locked for writing");
        return m_buffer;
    }

    void CheckValid()
    {
        if (m_buffer == null)
            throw new InvalidOperationException($"{Label} is used after it was disposed, or could not be made");
    }

    // What a fresh buffer holds is nobody's to count on.
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    unsafe void FillUndefined()
    {
        const uint words = Undefined * 0x01010101u;
        if ((usageFlags & UsageFlags.LockBufferForWrite) != 0)
            new Span<byte>(m_buffer.Mapped, (int)Bytes).Fill(Undefined);
        else
            Api.CmdFillBuffer(GpuDevice.Current.Queue.Open().Commands, m_buffer.Handle, 0, Vk.WholeSize, words);
    }

    static BufferUsageFlags UsageOf(Target target)
    {
        BufferUsageFlags usage = 0;
        if ((target & (Target.Structured | Target.Raw | Target.Append | Target.Counter)) != 0)
            usage |= BufferUsageFlags.StorageBufferBit;
        if ((target & Target.IndirectArguments) != 0)
            usage |= BufferUsageFlags.IndirectBufferBit;
        if ((target & Target.Index) != 0)
            usage |= BufferUsageFlags.IndexBufferBit;
        if ((target & Target.Constant) != 0)
            usage |= BufferUsageFlags.UniformBufferBit;
        return usage;
    }
}
