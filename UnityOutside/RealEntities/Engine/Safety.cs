using System.Diagnostics;

namespace Unity.Collections.LowLevel.Unsafe
{
    public enum EnforceJobResult
    {
        AllJobsAlreadySynced = 0,
        DidSyncRunningJobs = 1,
        HandleWasAlreadyDeallocated = 2,
    }

    public enum AtomicSafetyErrorType
    {
        Deallocated = 0,
        DeallocatedFromJob = 1,
        NotAllocatedFromJob = 2,
    }

    public unsafe partial struct AtomicSafetyHandle
    {
        internal const int ReadCheck = 0;
        internal const int WriteCheck = 0;
        internal const int ReadWriteDisposeCheck = 0;

        static readonly int* s_noVersion = (int*)NativeHeap.Allocate(4, 4);
        internal readonly int* versionNode => s_noVersion; // Never equal, so that who asks these goes on to the checks.
        internal readonly int version => -1;

        internal int staticSafetyId
        {
            readonly get => m_Name;
            set => m_Name = value;
        }

        internal static void CheckReadAndThrowNoEarlyOut(AtomicSafetyHandle handle) => CheckReadAndThrow(handle);
        internal static void CheckWriteAndThrowNoEarlyOut(AtomicSafetyHandle handle) => CheckWriteAndThrow(handle);

        public static void DisposeHandle(ref AtomicSafetyHandle handle)
        {
            CheckDeallocateAndThrow(handle);
            Release(handle);
            handle = default;
        }

        public static bool IsHandleValid(in AtomicSafetyHandle handle) =>
            handle.m_Node != null && handle.m_Version == handle.CurrentVersion;

        public static bool IsTempMemoryHandle(AtomicSafetyHandle handle) => (handle.m_Flags & Temp) != 0;

        public static int NewStaticSafetyId(byte* ownerTypeNameBytes, int byteCount) =>
            SafetyNames.IdOf(Encoding.UTF8.GetString(ownerTypeNameBytes, byteCount));

        public static void SetCustomErrorMessage(int staticSafetyId, AtomicSafetyErrorType errorType, byte* messageBytes,
            int byteCount) { }
        public static void SetNestedContainer(AtomicSafetyHandle handle, bool isNestedContainer) { }
        public static void SetExclusiveWeak(ref AtomicSafetyHandle handle, bool value) { }
        public static void SetAllowSecondaryVersionWriting(AtomicSafetyHandle handle, bool allowWriting) { }

        public static EnforceJobResult EnforceAllBufferJobsHaveCompleted(AtomicSafetyHandle handle)
        {
            if (handle.m_Node == null)
                return EnforceJobResult.HandleWasAlreadyDeallocated;
            JobAccess[] accesses = Accesses(handle).ToArray();
            foreach (JobAccess access in accesses)
                access.Record.Handle.Complete();
            return accesses.Length == 0 ? EnforceJobResult.AllJobsAlreadySynced : EnforceJobResult.DidSyncRunningJobs;
        }

        public static EnforceJobResult EnforceAllBufferJobsHaveCompletedAndRelease(AtomicSafetyHandle handle)
        {
            EnforceJobResult result = EnforceAllBufferJobsHaveCompleted(handle);
            Release(handle);
            return result;
        }

        public static int GetReaderArray(AtomicSafetyHandle handle, int maxCount, IntPtr output)
        {
            JobAccess[] readers = Readers(handle);
            for (int i = 0; i < readers.Length && i < maxCount; i++)
                ((JobHandle*)output)[i] = readers[i].Record.Handle;
            return readers.Length;
        }

        public static string GetReaderName(AtomicSafetyHandle handle, int readerIndex) => Readers(handle)[readerIndex].Job;
        public static JobHandle GetWriter(AtomicSafetyHandle handle) => Writer(handle)?.Record.Handle ?? default;
        public static string GetWriterName(AtomicSafetyHandle handle) => Writer(handle)?.Job;

        static IEnumerable<JobAccess> Accesses(AtomicSafetyHandle handle) =>
            InFlightJobs.Of(handle.m_Node) ?? Enumerable.Empty<JobAccess>();
        static JobAccess[] Readers(AtomicSafetyHandle handle) => Accesses(handle).Where(a => !a.Writes).ToArray();
        static JobAccess Writer(AtomicSafetyHandle handle) => Accesses(handle).FirstOrDefault(a => a.Writes);
    }

    public static unsafe partial class NativeArrayUnsafeUtility
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        public static AtomicSafetyHandle GetAtomicSafetyHandle<T>(NativeArray<T> array) where T : struct => array.m_Safety;
#endif
    }
}

namespace Unity.Collections
{
    public unsafe partial struct NativeArray<T>
    {
        public partial struct ReadOnly
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal ReadOnly(void* buffer, int length, ref AtomicSafetyHandle safety) : this(buffer, length, safety) { }
#endif
        }
    }
}
