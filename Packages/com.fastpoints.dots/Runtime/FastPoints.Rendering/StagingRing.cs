using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // Uploads through mapped buffers in turn, from which a compute shader copies. One is reused when the GPU has certainly read
    // it.
    internal sealed unsafe class StagingRing : IDisposable
    {
        // The most frames that the GPU usually lags behind: an editor or player queues two, or three if asked to. Where the GPU
        // reports its progress, it may lag further.
        public const int FramesInFlight = 3;

        readonly ComputeShader m_copyPages;
        readonly int m_kernel;
        readonly StagingBuffer[] m_buffers = new StagingBuffer[FramesInFlight + 1];
        readonly GraphicsFence[] m_fences = new GraphicsFence[FramesInFlight + 1];
        readonly bool[] m_isSent = new bool[FramesInFlight + 1];
        readonly long[] m_freeAtFrame = new long[FramesInFlight + 1];
        readonly bool m_hasFences = SystemInfo.supportsGraphicsFence;
        NativeList<int> m_endOfBank;
        int m_next;

        public StagingRing(ComputeShader copyPages)
        {
            m_copyPages = copyPages;
            m_kernel = copyPages.FindKernel(ShaderNames.CopyPagesKernel);
            for (int i = 0; i < m_buffers.Length; i++)
                m_buffers[i] = new StagingBuffer();
            m_endOfBank = new NativeList<int>(Allocator.Persistent);
        }

        // Only frames with a picture count; a larger node reserves more than the pages. False if there is no memory.
        public bool TryBegin(long frame, int pages)
        {
            if (m_isSent[m_next] && !HasBeenRead(frame))
                return false;
            m_isSent[m_next] = false;
            m_buffers[m_next].Begin(pages);
            return true;
        }

        // The first always fits; null if it does not.
        public byte* Take(PoolRange range) => m_buffers[m_next].Take(range);

        // After everything is written: later draws find it in the pool.
        public void End(List<GraphicsBuffer> banks, long frame)
        {
            m_buffers[m_next].CopyTo(banks, m_copyPages, m_kernel, m_endOfBank);
            m_freeAtFrame[m_next] = frame + FramesInFlight + 1;
            if (m_hasFences)
                m_fences[m_next] = Graphics.CreateGraphicsFence(GraphicsFenceType.CPUSynchronisation,
                    SynchronisationStageFlags.ComputeProcessing);
            m_isSent[m_next] = true;
            m_next = (m_next + 1) % m_buffers.Length;
        }

        public void Dispose()
        {
            if (!m_endOfBank.IsCreated)
                return;
            foreach (var buffer in m_buffers)
                buffer.Dispose();
            m_endOfBank.Dispose();
        }

        // Frames are only counted for GPUs without fences, which may lag further than any setting says.
        bool HasBeenRead(long frame) => m_hasFences ? m_fences[m_next].passed : m_freeAtFrame[m_next] <= frame;
    }
}
