using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Unity.Collections
{
    [NativeContainer]
    public unsafe struct NativeReference<T> : INativeDisposable, IEquatable<NativeReference<T>> where T : unmanaged
    {
        [NativeDisableUnsafePtrRestriction]
        internal void* m_Data;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        internal AtomicSafetyHandle m_Safety;
        static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeReference<T>>();
#endif
        internal AllocatorManager.AllocatorHandle m_AllocatorLabel;

        public NativeReference(AllocatorManager.AllocatorHandle allocator,
            NativeArrayOptions options = NativeArrayOptions.ClearMemory)
        {
            CollectionHelper.CheckAllocator(allocator);
            m_AllocatorLabel = allocator;
            m_Data = AllocatorManager.Allocate<T>(allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            m_Safety = CollectionHelper.CreateSafetyHandle(allocator);
            AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
#endif
            if (options == NativeArrayOptions.ClearMemory)
                *(T*)m_Data = default;
        }

        public NativeReference(T value, AllocatorManager.AllocatorHandle allocator)
            : this(allocator, NativeArrayOptions.UninitializedMemory)
        {
            *(T*)m_Data = value;
        }

        public T Value
        {
            get
            {
                CheckRead();
                return *(T*)m_Data;
            }
            set
            {
                CheckWrite();
                *(T*)m_Data = value;
            }
        }

        public readonly bool IsCreated => m_Data != null;

        public void Dispose()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (!AtomicSafetyHandle.IsDefaultValue(m_Safety))
                AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
            if (!IsCreated)
                return;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            CollectionHelper.DisposeSafetyHandle(ref m_Safety);
#endif
            AllocatorManager.Free(m_AllocatorLabel, m_Data);
            m_AllocatorLabel = AllocatorManager.Invalid;
            m_Data = null;
        }

        public JobHandle Dispose(JobHandle inputDeps)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (!AtomicSafetyHandle.IsDefaultValue(m_Safety))
                AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
            if (!IsCreated)
                return inputDeps;
            JobHandle disposed = new DisposeJob { Data = this }.Schedule(inputDeps);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.Release(m_Safety);
#endif
            m_Data = null;
            return disposed;
        }

        public void CopyFrom(NativeReference<T> reference) => Copy(this, reference);

        public void CopyTo(NativeReference<T> reference) => Copy(reference, this);

        public static void Copy(NativeReference<T> dst, NativeReference<T> src) => dst.Value = src.Value;

        public ReadOnly AsReadOnly()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            return new ReadOnly(m_Data, m_Safety);
#else
            return new ReadOnly(m_Data);
#endif
        }

        public static implicit operator ReadOnly(NativeReference<T> nativeReference) => nativeReference.AsReadOnly();

        public bool Equals(NativeReference<T> other) => Value.Equals(other.Value);

        public override bool Equals(object obj) => obj is NativeReference<T> other && Equals(other);

        public override int GetHashCode() => Value.GetHashCode();

        public static bool operator ==(NativeReference<T> left, NativeReference<T> right) => left.Equals(right);

        public static bool operator !=(NativeReference<T> left, NativeReference<T> right) => !left.Equals(right);

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal readonly void CheckRead()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal readonly void CheckWrite()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
#endif
        }

        [NativeContainer]
        [NativeContainerIsReadOnly]
        public struct ReadOnly
        {
            [NativeDisableUnsafePtrRestriction]
            readonly void* m_Data;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;

            internal ReadOnly(void* data, AtomicSafetyHandle safety)
            {
                m_Data = data;
                m_Safety = safety;
            }
#else
            internal ReadOnly(void* data)
            {
                m_Data = data;
            }
#endif

            public T Value
            {
                get
                {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                    AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
                    return *(T*)m_Data;
                }
            }
        }

        struct DisposeJob : IJob
        {
            internal NativeReference<T> Data;

            public void Execute() => AllocatorManager.Free(Data.m_AllocatorLabel, Data.m_Data);
        }
    }
}

namespace Unity.Collections.LowLevel.Unsafe
{
    public static unsafe class NativeReferenceUnsafeUtility
    {
        public static T* GetUnsafePtr<T>(this NativeReference<T> reference) where T : unmanaged
        {
            reference.CheckWrite();
            return (T*)reference.m_Data;
        }

        public static T* GetUnsafeReadOnlyPtr<T>(this NativeReference<T> reference) where T : unmanaged
        {
            reference.CheckRead();
            return (T*)reference.m_Data;
        }

        public static T* GetUnsafePtrWithoutChecks<T>(this NativeReference<T> reference) where T : unmanaged =>
            (T*)reference.m_Data;
    }
}
