using System;
using FastPoints.Drawing;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Evaluation
{
    /// <summary>The nodes of one cloud that a frame draws, with all that drawing them takes: views of the pool's memory, or, if
    /// they are kept for later frames, of a copy. Main thread.</summary>
    internal sealed unsafe class DrawnBlocks : IDisposable
    {
        NativeList<GpuSizeNode> m_sizeNodes = new NativeList<GpuSizeNode>(Allocator.Persistent);
        NativeList<long> m_bytesOfPlane = new NativeList<long>(Allocator.Persistent);
        NativeList<byte> m_copy = new NativeList<byte>(Allocator.Persistent);

        public NativeList<NodeBlocks> Nodes { get; } = new NativeList<NodeBlocks>(Allocator.Persistent);
        public NativeList<PlaneView> Planes { get; } = new NativeList<PlaneView>(Allocator.Persistent);
        public NativeArray<GpuSizeNode> SizeNodes => m_sizeNodes.AsArray(); // Nodes of a SizeTree; empty if no size is adaptive.

        public void Clear(NativeArray<GpuSizeNode> sizeNodes)
        {
            Nodes.Clear();
            Planes.Clear();
            m_bytesOfPlane.Clear();
            m_sizeNodes.Clear();
            m_sizeNodes.AddRange(sizeNodes);
        }

        public void Add(PlaneView plane, long bytes)
        {
            Planes.Add(plane);
            m_bytesOfPlane.Add(bytes);
        }

        public void CopyFrom(DrawnBlocks from)
        {
            Clear(from.SizeNodes);
            Nodes.AddRange(from.Nodes.AsArray());
            long total = 0;
            foreach (long bytes in from.m_bytesOfPlane)
                total += bytes;
            m_copy.ResizeUninitialized(checked((int)total));
            byte* at = m_copy.GetUnsafePtr();
            for (int i = 0; i < from.Planes.Length; i++)
            {
                var plane = from.Planes[i];
                long bytes = from.m_bytesOfPlane[i];
                UnsafeUtility.MemCpy(at, plane.Words, bytes);
                plane.Words = (uint*)at;
                Add(plane, bytes);
                at += bytes;
            }
        }

        public void Dispose()
        {
            if (!Nodes.IsCreated)
                return;
            Nodes.Dispose();
            Planes.Dispose();
            m_sizeNodes.Dispose();
            m_bytesOfPlane.Dispose();
            m_copy.Dispose();
        }
    }
}
