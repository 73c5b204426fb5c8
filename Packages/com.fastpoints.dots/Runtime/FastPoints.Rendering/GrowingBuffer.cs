using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>A buffer that is rewritten for each picture and grows when it must.</summary>
    internal sealed class GrowingBuffer : IDisposable
    {
        readonly GraphicsBuffer.Target m_target;
        readonly int m_strideBytes;

        /// <param name="strideBytes">Size of an element; 4 for raw buffers.</param>
        public GrowingBuffer(GraphicsBuffer.Target target, int strideBytes)
        {
            m_target = target;
            m_strideBytes = strideBytes;
        }

        /// <summary>Null until something was written.</summary>
        public GraphicsBuffer Buffer { get; private set; }

        /// <summary>Records that the buffer has these values from here on.</summary>
        public void Write<T>(CommandBuffer commands, NativeArray<T> values) where T : unmanaged
        {
            if (values.Length == 0)
                return;
            long bytes = (long)values.Length * UnsafeUtility.SizeOf<T>();
            if (Buffer == null || (long)Buffer.count * m_strideBytes < bytes)
            {
                Dispose();
                Buffer = new GraphicsBuffer(m_target, math.ceilpow2((int)(bytes / m_strideBytes)), m_strideBytes);
            }
            commands.SetBufferData(Buffer, values, 0, 0, values.Length);
        }

        public void Dispose()
        {
            Buffer?.Dispose();
            Buffer = null;
        }
    }
}
