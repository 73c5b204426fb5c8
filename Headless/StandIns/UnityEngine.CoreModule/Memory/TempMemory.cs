using System;
using System.Collections.Generic;

namespace StandIns.Memory
{
    /// <summary>
    /// Allocator.Temp: memory of one thread that nobody has to give back. What a job leaves is freed when it ends, what the main
    /// thread leaves when the frame ends.
    /// </summary>
    static unsafe class TempMemory
    {
        [ThreadStatic]
        static List<IntPtr> t_blocks;

        /// <summary>Blocks of this thread that are alive: what <see cref="FreeAbove"/> takes back later.</summary>
        internal static int Mark => t_blocks == null ? 0 : t_blocks.Count;

        internal static void* Allocate(long size, int alignment)
        {
            void* memory = NativeHeap.Allocate(size, alignment);
            (t_blocks ??= new List<IntPtr>()).Add((IntPtr)memory);
            return memory;
        }

        internal static void Free(void* memory)
        {
            int at = t_blocks == null ? -1 : t_blocks.LastIndexOf((IntPtr)memory);
            // Not found: freed already with its job or frame, which Unity lets pass too.
            if (at < 0)
                return;
            t_blocks.RemoveAt(at);
            NativeHeap.Free(memory);
        }

        internal static void FreeAbove(int mark)
        {
            if (t_blocks == null)
                return;
            for (int i = t_blocks.Count - 1; i >= mark; i--)
                NativeHeap.Free((void*)t_blocks[i]);
            if (t_blocks.Count > mark)
                t_blocks.RemoveRange(mark, t_blocks.Count - mark);
        }
    }
}
