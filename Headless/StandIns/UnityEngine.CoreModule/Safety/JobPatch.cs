using System.Diagnostics;
using System.Threading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using SystemUnsafe = System.Runtime.CompilerServices.Unsafe;

namespace StandIns.Safety
{
    static class JobPatch
    {
        static int s_deferredArraysExist;

        /// <summary>Whether any list gave out a deferred array yet; until then no job is searched for one.</summary>
        internal static bool DeferredArraysExist => Volatile.Read(ref s_deferredArraysExist) != 0;

        internal static void NoteDeferredArray() => Volatile.Write(ref s_deferredArraysExist, 1);
    }

    /// <summary>What the job system writes into a job's copy of its struct before it runs. The copy lies in an object that a
    /// garbage collection may move at any time, so it is held while there is a pointer to it.</summary>
    static unsafe class JobPatch<T> where T : struct
    {
        static readonly int[] s_threadIndexOffsets = JobLayout.Of(typeof(T)).ThreadIndexOffsets;
        static readonly JobField[] s_deallocated = JobLayout.Of(typeof(T)).Deallocated;

        static class Arrays
        {
            internal static readonly JobField[] Deferrable = JobLayout.Of(typeof(T)).Deferrable;
            internal static readonly JobField[] Restricted = JobLayout.Of(typeof(T)).Restricted;
        }

        internal static void SetThreadIndex(ref T job, int threadIndex)
        {
            if (s_threadIndexOffsets.Length == 0)
                return;
            fixed (byte* at = &SystemUnsafe.As<T, byte>(ref job))
            {
                foreach (int offset in s_threadIndexOffsets)
                    *(int*)(at + offset) = threadIndex;
            }
        }

        /// <summary>
        /// A deferred array's buffer is the address of a list (its pointer, then its length) with the lowest bit set.
        /// </summary>
        internal static void ResolveDeferred(ref T job)
        {
            fixed (byte* at = &SystemUnsafe.As<T, byte>(ref job))
            {
                foreach (JobField field in Arrays.Deferrable)
                {
                    void** buffer = (void**)(at + field.Offset + field.Type.BufferOffset);
                    if (((ulong)*buffer & 1) == 0)
                        continue;
                    byte* list = (byte*)*buffer - 1;
                    int length = *(int*)(list + sizeof(void*));
                    *buffer = *(void**)list;
                    *(int*)(at + field.Offset + field.Type.LengthOffset) = length;
                    if (field.Type.MaxIndexOffset >= 0)
                        *(int*)(at + field.Offset + field.Type.MaxIndexOffset) = length - 1;
                }
            }
        }

        /// <summary>Arrays that are written in parallel may only be touched at the job's own indices.</summary>
        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        internal static void Restrict(ref T job, int begin, int end)
        {
            fixed (byte* at = &SystemUnsafe.As<T, byte>(ref job))
            {
                foreach (JobField field in Arrays.Restricted)
                {
                    *(int*)(at + field.Offset + field.Type.MinIndexOffset) = begin;
                    *(int*)(at + field.Offset + field.Type.MaxIndexOffset) = end - 1;
                }
            }
        }

        internal static void Deallocate(ref T job)
        {
            if (s_deallocated.Length == 0)
                return;
            fixed (byte* at = &SystemUnsafe.As<T, byte>(ref job))
            {
                foreach (JobField field in s_deallocated)
                    UnsafeUtility.FreeTracked(*(void**)(at + field.Offset + field.Type.BufferOffset),
                        *(Allocator*)(at + field.Offset + field.Type.AllocatorOffset));
            }
        }
    }
}
