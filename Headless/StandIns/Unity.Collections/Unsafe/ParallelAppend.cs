using System;
using System.Threading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace StandIns.Collections
{
    static class ParallelAppend
    {
        /// <summary>Room for <paramref name="count"/> more elements, for one thread alone.</summary>
        /// <returns>Index of the first.</returns>
        internal static int Reserve(ref int length, int capacity, int count)
        {
            int seen = Volatile.Read(ref length);
            while (true)
            {
                // Unity's writes beyond the buffer where checks are off; here it never does.
                if (seen + (long)count > capacity)
                    throw new InvalidOperationException($"AddNoResize assumes that list capacity is sufficient (Capacity "
                        + $"{capacity}, Length {seen}), requested length {seen + (long)count}!");
                int now = Interlocked.CompareExchange(ref length, seen + count, seen);
                if (now == seen)
                    return seen;
                seen = now;
            }
        }
    }

    /// <summary>Frees memory when the jobs that use it are done.</summary>
    unsafe struct FreeJob : IJob
    {
        [NativeDisableUnsafePtrRestriction]
        internal void* Memory;
        internal AllocatorManager.AllocatorHandle Allocator;

        public void Execute() => AllocatorManager.Free(Allocator, Memory);
    }
}
