namespace StandIns.Graphics;

sealed unsafe class GpuMemoryBlock
{
    internal readonly DeviceMemory Memory;
    internal readonly byte* Mapped; // Where the host sees it; null if it does not.
    internal readonly bool IsLarge;

    readonly ulong m_bytes;
    readonly int m_type;
    readonly bool m_isImage;
    readonly List<(ulong Start, ulong End)> m_free = new List<(ulong, ulong)>();

    internal GpuMemoryBlock(DeviceMemory memory, byte* mapped, ulong bytes, int type, bool isImage, bool isLarge)
    {
        Memory = memory;
        Mapped = mapped;
        IsLarge = isLarge;
        m_bytes = bytes;
        m_type = type;
        m_isImage = isImage;
        m_free.Add((0, bytes));
    }

    internal bool IsEmpty => m_free.Count == 1 && m_free[0] == (0, m_bytes);

    internal bool Fits(int type, bool isImage) => !IsLarge && m_type == type && m_isImage == isImage;

    internal bool TryTake(ulong bytes, ulong alignment, out ulong start)
    {
        for (int i = 0; i < m_free.Count; i++)
        {
            (ulong first, ulong end) = m_free[i];
            start = (first + alignment - 1) / alignment * alignment;
            if (start + bytes > end)
                continue;
            m_free.RemoveAt(i);
            if (start + bytes < end)
                m_free.Insert(i, (start + bytes, end));
            if (first < start)
                m_free.Insert(i, (first, start));
            return true;
        }
        start = 0;
        return false;
    }

    internal void Give(ulong start, ulong bytes)
    {
        ulong end = start + bytes;
        int at = 0;
        while (at < m_free.Count && m_free[at].Start < start)
            at++;
        if (at < m_free.Count && m_free[at].Start == end)
        {
            end = m_free[at].End;
            m_free.RemoveAt(at);
        }
        if (at > 0 && m_free[at - 1].End == start)
        {
            start = m_free[--at].Start;
            m_free.RemoveAt(at);
        }
        m_free.Insert(at, (start, end));
    }
}
