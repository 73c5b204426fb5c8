using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>The bound of uploads: pieces of a node's size are copied on one thread, from memory that no cache
    /// holds.</summary>
    public unsafe struct StreamMemoryCopyWorkload : IWorkload
    {
        const int PieceBytes = 64 << 10;

        NativeArray<byte> m_from;
        NativeArray<byte> m_to;

        public string Name => "stream memory copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            // What position and colour of the points take, about.
            int bytes = (int)Math.Max(PieceBytes, Math.Min(1 << 30, context.Points * 7L)) / PieceBytes * PieceBytes;
            m_from = new NativeArray<byte>(bytes, Allocator.Persistent);
            m_to = new NativeArray<byte>(bytes, Allocator.Persistent);
            Run();
        }

        public WorkloadResult Run()
        {
            var from = (byte*)m_from.GetUnsafeReadOnlyPtr();
            var to = (byte*)m_to.GetUnsafePtr();
            for (int at = 0; at < m_from.Length; at += PieceBytes)
                UnsafeUtility.MemCpy(to + at, from + at, PieceBytes);
            return new WorkloadResult { Bytes = m_from.Length };
        }

        public void Dispose()
        {
            if (!m_from.IsCreated)
                return;
            m_from.Dispose();
            m_to.Dispose();
        }
    }
}
