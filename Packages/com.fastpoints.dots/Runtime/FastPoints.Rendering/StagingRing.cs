using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
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
        public byte* Reserve(PoolRange range) => m_buffers[m_next].Reserve(range);

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

    // One upload in flight: mapped memory into which jobs write nodes, each starting on a page, and a list of the pages that
    // they go to. Mapped memory may be uncached: it is written front to back and never read.
    internal sealed unsafe class StagingBuffer : IDisposable
    {
        const int MaxGroups = 65535; // Of one dispatch on any GPU.
        const int PageEntryBytes = 2 * sizeof(uint);
        const int WordsPerPage = NodePool.PageBytes / sizeof(uint);

        GraphicsBuffer m_bytes;
        GraphicsBuffer m_pages;
        NativeArray<uint> m_words;
        NativeList<PoolRange> m_ranges; // In the order in which the nodes lie here.
        int m_pageCount;
        int m_requestedPages; // A larger node may have allocated more.

        public StagingBuffer() => m_ranges = new NativeList<PoolRange>(256, Allocator.Persistent);

        public bool IsLocked { get; private set; }

        // Begins an upload, in a new buffer if the requested size has changed.
        public void Begin(int pages)
        {
            if (pages != m_requestedPages)
                Create(m_requestedPages = pages);
            Lock();
        }

        void Lock()
        {
            m_words = m_bytes.LockBufferForWrite<uint>(0, m_bytes.count);
            m_ranges.Clear();
            m_pageCount = 0;
            IsLocked = true;
        }

        // Null if it does not fit. The first always fits.
        public byte* Reserve(PoolRange range)
        {
            if (m_pageCount + range.PageCount > m_pages.count)
            {
                if (m_pageCount > 0)
                    return null;
                Grow(range.PageCount);
            }
            m_ranges.Add(range);
            byte* at = (byte*)m_words.GetUnsafePtr() + (long)m_pageCount * NodePool.PageBytes;
            m_pageCount += range.PageCount;
            return at;
        }

        // After earlier draws. endOfBank is scratch.
        public void CopyTo(List<GraphicsBuffer> banks, ComputeShader copyPages, int kernel, NativeList<int> endOfBank)
        {
            Unlock();
            ListPages(banks.Count, endOfBank);
            copyPages.SetBuffer(kernel, ShaderNames.Staging, m_bytes);
            copyPages.SetBuffer(kernel, ShaderNames.Pages, m_pages);
            int first = 0;
            for (int bank = 0; bank < endOfBank.Length; bank++)
            {
                if (endOfBank[bank] == first)
                    continue;
                copyPages.SetBuffer(kernel, ShaderNames.BankOut, banks[bank]);
                while (first < endOfBank[bank])
                {
                    int groups = math.min(endOfBank[bank] - first, MaxGroups);
                    copyPages.SetInt(ShaderNames.FirstPage, first);
                    copyPages.Dispatch(kernel, groups, 1, 1);
                    first += groups;
                }
            }
        }

        public void Dispose()
        {
            if (!m_ranges.IsCreated)
                return;
            if (IsLocked)
                Unlock();
            m_bytes?.Dispose();
            m_pages?.Dispose();
            m_ranges.Dispose();
        }

        // Where each lies here and where it goes, bank by bank.
        void ListPages(int bankCount, NativeList<int> endOfBank)
        {
            endOfBank.ResizeUninitialized(bankCount);
            for (int bank = 0; bank < bankCount; bank++)
                endOfBank[bank] = 0;
            for (int i = 0; i < m_ranges.Length; i++)
                endOfBank[m_ranges[i].Bank] += m_ranges[i].PageCount;
            int first = 0;
            for (int bank = 0; bank < bankCount; bank++)
            {
                int count = endOfBank[bank];
                endOfBank[bank] = first;
                first += count;
            }
            var pages = m_pages.LockBufferForWrite<uint2>(0, m_pageCount);
            var to = (uint2*)pages.GetUnsafePtr();
            uint from = 0;
            for (int i = 0; i < m_ranges.Length; i++)
            {
                var range = m_ranges[i];
                for (int page = 0; page < range.PageCount; page++)
                    to[endOfBank[range.Bank]++] = new uint2(from++, (uint)(range.FirstPage + page));
            }
            m_pages.UnlockBufferAfterWrite<uint2>(m_pageCount);
        }

        void Unlock()
        {
            m_bytes.UnlockBufferAfterWrite<uint>(m_pageCount * WordsPerPage);
            m_words = default;
            IsLocked = false;
        }

        void Grow(int pages)
        {
            Unlock();
            Create(pages);
            Lock();
        }

        void Create(int pages)
        {
            m_bytes?.Dispose();
            m_pages?.Dispose();
            m_bytes = new GraphicsBuffer(GraphicsBuffer.Target.Raw, GraphicsBuffer.UsageFlags.LockBufferForWrite,
                pages * WordsPerPage, sizeof(uint));
            m_pages = new GraphicsBuffer(GraphicsBuffer.Target.Structured, GraphicsBuffer.UsageFlags.LockBufferForWrite, pages,
                PageEntryBytes);
        }
    }
}
