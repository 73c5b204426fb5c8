namespace Unity.Collections
{
    [NativeContainer]
    public unsafe struct NativeReference<T> : IDisposable where T : unmanaged
    {
        [NativeDisableUnsafePtrRestriction] internal T* m_Data;
        internal AtomicSafetyHandle m_Safety;
        internal AllocatorManager.AllocatorHandle m_AllocatorLabel;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeReference<T>>();
#endif

        public NativeReference(AllocatorManager.AllocatorHandle allocator,
            NativeArrayOptions options = NativeArrayOptions.ClearMemory)
        {
            m_AllocatorLabel = allocator;
            m_Data = AllocatorManager.Allocate<T>(allocator);
            m_Safety = ContainerChecks.CreateSafetyHandle(allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
#endif
            if (options == NativeArrayOptions.ClearMemory)
                *m_Data = default;
        }

        public NativeReference(T value, AllocatorManager.AllocatorHandle allocator)
            : this(allocator, NativeArrayOptions.UninitializedMemory) => *m_Data = value;

        public T Value
        {
            get
            {
                AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
                return *m_Data;
            }
            set
            {
                AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
                *m_Data = value;
            }
        }

        public readonly bool IsCreated => m_Data != null;

        public void Dispose()
        {
            if (!ContainerChecks.TryRelease(m_Safety, IsCreated))
                return;
            AllocatorManager.Free(m_AllocatorLabel, m_Data);
            m_Data = null;
        }
    }
}

namespace Unity.Collections.LowLevel.Unsafe
{
    public static unsafe class NativeReferenceUnsafeUtility
    {
        public static T* GetUnsafePtr<T>(this NativeReference<T> reference) where T : unmanaged
        {
            AtomicSafetyHandle.CheckWriteAndThrow(reference.m_Safety);
            return reference.m_Data;
        }
    }
}
