namespace Unity.Collections.LowLevel.Unsafe
{
    public static unsafe class NativeListUnsafeUtility
    {
        public static T* GetUnsafePtr<T>(this NativeList<T> list) where T : unmanaged
        {
            list.CheckWrite();
            return list.m_ListData->Ptr;
        }

        public static T* GetUnsafeReadOnlyPtr<T>(this NativeList<T> list) where T : unmanaged
        {
            list.CheckRead();
            return list.m_ListData->Ptr;
        }

        public static AtomicSafetyHandle GetAtomicSafetyHandle<T>(ref NativeList<T> list) where T : unmanaged
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            return list.m_Safety;
#else
            return default;
#endif
        }
    }
}
