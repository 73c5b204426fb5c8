using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    // A decoder's state somewhere within a chunk. Pages of zeros (unused models) are not kept: about 0.3 of 1.4 MB are. It is not
    // in managed memory because a preview keeps a hundred of them, and the editor's managed heap never shrinks.
    sealed unsafe class LazCheckpoint : DecoderState
    {
        const int PageBytes = 4096;

        NativeList<int> m_pages;
        NativeList<byte> m_content;
        JobHandle m_last;
        public long Point; // Decoded next, counted from the chunk's start.

        public long FileOffset;

        public override long Bytes
        {
            get
            {
                m_last.Complete();
                return HasState ? m_content.Capacity : 0;
            }
        }

        public bool HasState => m_content.IsCreated;

        // Keeps the position: the block then decodes from an earlier checkpoint. Its jobs have ended: slots are disposed before
        // it.
        public void Drop()
        {
            if (!HasState)
                return;
            m_pages.Dispose();
            m_content.Dispose();
        }

        public override void Dispose() => Drop();

        // Takes 2 ms.
        public JobHandle Save(NativeArray<byte> state, JobHandle inputDeps)
        {
            if (!HasState)
            {
                m_pages = new NativeList<int>(Allocator.Persistent);
                m_content = new NativeList<byte>(Allocator.Persistent);
            }
            return m_last = new SaveJob { State = state, Pages = m_pages, Content = m_content }.Schedule(
                JobHandle.CombineDependencies(m_last, inputDeps));
        }

        public JobHandle Restore(NativeArray<byte> state, JobHandle inputDeps) =>
            m_last = new RestoreJob { Pages = m_pages, Content = m_content, State = state }.Schedule(
                JobHandle.CombineDependencies(m_last, inputDeps));

        static int LengthOf(int page, int bytes) => bytes - page * PageBytes < PageBytes ? bytes - page * PageBytes : PageBytes;

        [BurstCompile]
        struct SaveJob : IJob
        {
            [ReadOnly] public NativeArray<byte> State;
            public NativeList<int> Pages;
            public NativeList<byte> Content;

            public void Execute()
            {
                Pages.Clear();
                byte* from = (byte*)State.GetUnsafeReadOnlyPtr();
                int pages = (State.Length + PageBytes - 1) / PageBytes;
                for (int page = 0; page < pages; page++)
                    if (!IsZero(from, page, State.Length))
                        Pages.Add(page);
                Content.ResizeUninitialized(Pages.Length * PageBytes);
                byte* to = (byte*)Content.GetUnsafePtr();
                for (int i = 0; i < Pages.Length; i++)
                    UnsafeUtility.MemCpy(to + (long)i * PageBytes, from + (long)Pages[i] * PageBytes,
                        LengthOf(Pages[i], State.Length));
            }

            // Each byte the one before it, and the first eight of them zero: compared at the speed of memory.
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

        [BurstCompile]
        struct RestoreJob : IJob
        {
            [ReadOnly] public NativeList<int> Pages;
            [ReadOnly] public NativeList<byte> Content;
            public NativeArray<byte> State;

            public void Execute()
            {
                byte* to = (byte*)State.GetUnsafePtr();
                byte* from = (byte*)Content.GetUnsafeReadOnlyPtr();
                int next = 0;
                for (int i = 0; i < Pages.Length; i++)
                {
                    Clear(to, next, Pages[i]);
                    UnsafeUtility.MemCpy(to + (long)Pages[i] * PageBytes, from + (long)i * PageBytes,
                        LengthOf(Pages[i], State.Length));
                    next = Pages[i] + 1;
                }
                Clear(to, next, (State.Length + PageBytes - 1) / PageBytes);
            }

            void Clear(byte* state, int firstPage, int endPage)
            {
                long end = Math.Min((long)endPage * PageBytes, State.Length);
                if (end > (long)firstPage * PageBytes)
                    UnsafeUtility.MemClear(state + (long)firstPage * PageBytes, end - (long)firstPage * PageBytes);
            }
        }
    }
}
