namespace StandIns.Graphics;

sealed unsafe class UploadArena(GpuDevice device)
{
    const ulong ChunkBytes = 256 << 10;
    const ulong Alignment = 256;

    readonly GpuDevice m_device = device;
    readonly List<GpuBuffer> m_chunks = new List<GpuBuffer>();
    int m_chunk;
    ulong m_used;

    internal ulong Bytes { get; private set; } // Bytes handed out since the last reset.

    internal void Reset()
    {
        // What one large upload took is kept only while the next one wants it as well.
        for (int i = m_chunks.Count - 1; i > m_chunk; i--)
            if (m_chunks[i].Bytes > ChunkBytes)
            {
                m_chunks[i].Destroy(m_device);
                m_chunks.RemoveAt(i);
            }
        m_chunk = 0;
        m_used = 0;
        Bytes = 0;
    }

    internal byte* Take(ulong bytes, out GpuBuffer buffer, out ulong offset)
    {
        while (m_chunk < m_chunks.Count && m_used + bytes > m_chunks[m_chunk].Bytes)
        {
            m_chunk++;
            m_used = 0;
        }
        if (m_chunk == m_chunks.Count)
        {
            const BufferUsageFlags usage = BufferUsageFlags.UniformBufferBit;
            m_chunks.Add(GpuBuffer.TryCreate(m_device, Math.Max(ChunkBytes, bytes), usage, isForHost: true)
                ?? throw new OutOfMemoryException("No graphics memory for an upload of " + bytes + " bytes"));
        }
        buffer = m_chunks[m_chunk];
        offset = m_used;
        m_used = (m_used + bytes + Alignment - 1) / Alignment * Alignment;
        Bytes += bytes;
        return buffer.Mapped + offset;
    }
}
