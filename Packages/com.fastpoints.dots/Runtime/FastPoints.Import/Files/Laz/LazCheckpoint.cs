using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Files
{
    /// <summary>A decoder's state somewhere within a chunk, from which decoding can continue. Pages of zeros (unused models) are
    /// not kept: about 0.3 of 1.4 MB are. It is not in managed memory because a preview keeps a hundred of them, and the editor's
    /// managed heap never shrinks.</summary>
    sealed unsafe class LazCheckpoint : DecoderState
    {
        const int PageBytes = 4096;

        /// <summary>Room grows by this many pages, so that a reused one seldom has to grow.</summary>
        const int PagesPerGrowth = 16;

        readonly List<int> m_pages = new List<int>();
        NativeArray<byte> m_content;

        /// <summary>First point that the state decodes next, counted from the chunk's start.</summary>
        public long Point;

        /// <summary>Byte of the file at which its input starts.</summary>
        public long FileOffset;

        public override long Bytes => m_content.IsCreated ? m_content.Length : 0;

        public bool HasState => m_content.IsCreated;

        /// <summary>Drops the state but keeps the position: the block then decodes from an earlier checkpoint.</summary>
        public void Drop()
        {
            if (m_content.IsCreated)
                m_content.Dispose();
            m_content = default;
        }

        public override void Dispose() => Drop();

        public void Save(NativeArray<byte> state)
        {
            m_pages.Clear();
            byte* from = (byte*)state.GetUnsafeReadOnlyPtr();
            int pages = (state.Length + PageBytes - 1) / PageBytes;
            for (int page = 0; page < pages; page++)
                if (!IsZero(from, page, state.Length))
                    m_pages.Add(page);
            Reserve(m_pages.Count);
            byte* to = (byte*)m_content.GetUnsafePtr();
            for (int i = 0; i < m_pages.Count; i++)
                UnsafeUtility.MemCpy(to + (long)i * PageBytes, from + (long)m_pages[i] * PageBytes,
                    LengthOf(m_pages[i], state.Length));
        }

        public void Restore(NativeArray<byte> state)
        {
            byte* to = (byte*)state.GetUnsafePtr();
            byte* from = (byte*)m_content.GetUnsafeReadOnlyPtr();
            int next = 0;
            for (int i = 0; i < m_pages.Count; i++)
            {
                Clear(to, next, m_pages[i], state.Length);
                UnsafeUtility.MemCpy(to + (long)m_pages[i] * PageBytes, from + (long)i * PageBytes,
                    LengthOf(m_pages[i], state.Length));
                next = m_pages[i] + 1;
            }
            Clear(to, next, (state.Length + PageBytes - 1) / PageBytes, state.Length);
        }

        void Reserve(int pages)
        {
            if (m_content.IsCreated && m_content.Length >= pages * PageBytes)
                return;
            Drop();
            int room = (pages / PagesPerGrowth + 1) * PagesPerGrowth;
            m_content = new NativeArray<byte>(room * PageBytes, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        }

        static void Clear(byte* state, int firstPage, int endPage, int bytes)
        {
            long end = Math.Min((long)endPage * PageBytes, bytes);
            if (end > (long)firstPage * PageBytes)
                UnsafeUtility.MemClear(state + (long)firstPage * PageBytes, end - (long)firstPage * PageBytes);
        }

        static int LengthOf(int page, int bytes) => bytes - page * PageBytes < PageBytes ? bytes - page * PageBytes : PageBytes;

        /// <summary>Each byte the one before it, and the first eight of them zero: compared at the speed of memory.</summary>
        static bool IsZero(byte* state, int page, int bytes)
        {
            byte* at = state + (long)page * PageBytes;
            int length = LengthOf(page, bytes);
            for (int i = 0; i < 8 && i < length; i++)
                if (at[i] != 0)
                    return false;
            return length <= 8 || UnsafeUtility.MemCmp(at, at + 8, length - 8) == 0;
        }
    }
}
