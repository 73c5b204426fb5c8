using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // A buffer that is rewritten for each picture and grows as needed. Elements of raw buffers have 4 bytes.
    internal sealed class GrowingBuffer : IDisposable
    {
        readonly GraphicsBuffer.Target m_target;
        readonly int m_strideBytes;

        public GrowingBuffer(GraphicsBuffer.Target target, int strideBytes) =>
            (m_target, m_strideBytes) = (target, strideBytes);

        public GraphicsBuffer Buffer { get; private set; } // Null until the first reservation.

        // Whether the buffer is new, without its former content.
        public bool Reserve(long bytes)
        {
            if (Buffer != null && (long)Buffer.count * m_strideBytes >= bytes)
                return false;
            Dispose();
            long max = SystemInfo.maxGraphicsBufferSize / m_strideBytes;
            long count = (bytes + m_strideBytes - 1) / m_strideBytes;
            Buffer = new GraphicsBuffer(m_target, (int)math.max(count, math.min(math.ceilpow2((int)count), max)), m_strideBytes);
            return true;
        }

        // At a multiple of a value's size.
        public void Write<T>(CommandBuffer commands, NativeArray<T> values, int atByte = 0) where T : unmanaged
        {
            if (values.Length > 0)
                commands.SetBufferData(Buffer, values, 0, atByte / UnsafeUtility.SizeOf<T>(), values.Length);
        }

        public void Dispose()
        {
            Buffer?.Dispose();
            Buffer = null;
        }
    }
}
