namespace UnityEngine;

public sealed unsafe partial class GraphicsBuffer
{
    const byte Undefined = 0xCD; // What is in a locked range before it is written; nobody may count on what was there.

    int m_lockedBytes;
    bool m_isLocked;
    int m_lockedElement;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    AtomicSafetyHandle m_lockSafety;
#endif

    internal bool IsLocked => m_isLocked;

    /// <summary>The memory of a range, to be written in order and not read. Indices and counts are of
    /// <typeparamref name="T"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The range is not within the buffer.</exception>
    /// <exception cref="InvalidOperationException">Disposed, not made with LockBufferForWrite, locked already, or the device
    /// may still read it: no fence and no end of a frame has told that it is done. (Unity gives the memory all the same, and
    /// the device reads what is written too early.)</exception>
    public NativeArray<T> LockBufferForWrite<T>(int bufferStartIndex, int count) where T : struct
    {
        CheckValid();
        if ((usageFlags & UsageFlags.LockBufferForWrite) == 0)
            throw new InvalidOperationException($"{Label} was not made with UsageFlags.LockBufferForWrite");
        if (IsLocked)
            throw new InvalidOperationException($"{Label} is locked already");
        int size = UnsafeUtility.SizeOf<T>();
        CheckRange(bufferStartIndex, count, size);
        GpuQueue queue = GpuDevice.Current.Queue;
        if (m_buffer.LastUse > queue.Known)
            throw new InvalidOperationException($"{Label} is locked while the GPU may still use it: wait for a fence, or for "
                + $"as many "
                + "frames as are in flight");
        m_isLocked = true;
        m_lockedBytes = count * size;
        m_lockedElement = size;
        byte* first = m_buffer.Mapped + (long)bufferStartIndex * size;
        NativeArray<T> array = NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>(first, count, Allocator.None);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        new Span<byte>(first, m_lockedBytes).Fill(Undefined);
        m_lockSafety = AtomicSafetyHandle.Create();
        NativeArrayUnsafeUtility.SetAtomicSafetyHandle(ref array, m_lockSafety);
#endif
        return array;
    }

    /// <summary>Ends the lock and the array that it gave; the elements written are the first of the range.</summary>
    /// <exception cref="InvalidOperationException">Not locked, or a job that writes has not been completed.</exception>
    public void UnlockBufferAfterWrite<T>(int countWritten) where T : struct
    {
        CheckValid();
        if (!IsLocked)
            throw new InvalidOperationException($"{Label} is not locked");
        int size = UnsafeUtility.SizeOf<T>();
        if (size != m_lockedElement)
            throw new InvalidOperationException($"{Label} was locked as elements of {m_lockedElement} bytes, is unlocked as "
                + $"{size}");
        if (countWritten < 0 || (long)countWritten * size > m_lockedBytes)
            throw new ArgumentOutOfRangeException(nameof(countWritten),
                $"{Label}: {countWritten} elements are not within the {m_lockedBytes / size} that were locked");
        EndLock();
    }

    void EndLock()
    {
        if (!IsLocked)
            return;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        AtomicSafetyHandle.CheckDeallocateAndThrow(m_lockSafety);
        AtomicSafetyHandle.Release(m_lockSafety);
#endif
        m_isLocked = false;
    }

    void CheckRange(int start, int count, int size)
    {
        if (start < 0 || count < 0 || ((long)start + count) * size > Bytes)
            throw new ArgumentOutOfRangeException(nameof(count),
                $"{Label}: elements {start} to {(long)start + count} of {size} bytes are not within its {Bytes} bytes");
    }
}
