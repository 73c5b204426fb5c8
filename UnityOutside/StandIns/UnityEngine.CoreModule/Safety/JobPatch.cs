namespace StandIns.Safety;

/// <summary>What the job system writes into a job's copy of its struct before it runs. The copy lies in an object that a
/// garbage collection may move at any time, so it is held while there is a pointer to it.</summary>
static unsafe class JobPatch<T> where T : struct
{
    static readonly int[] s_threadIndexOffsets = JobLayout.Of(typeof(T)).ThreadIndexOffsets;
    static readonly JobField[] s_deallocated = JobLayout.Of(typeof(T)).Deallocated;

    static class Arrays
    {
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
