using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using StandIns.Collections;
using StandIns.Safety;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Unity.Collections
{
    [NativeContainer]
    [DebuggerDisplay("Length = {Length}, Capacity = {Capacity}")]
    public unsafe struct NativeList<T> : INativeDisposable, INativeList<T>, IEnumerable<T> where T : unmanaged
    {
        [NativeDisableUnsafePtrRestriction]
        internal UnsafeList<T>* m_ListData;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        internal AtomicSafetyHandle m_Safety;
        static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeList<T>>();
#endif

        public NativeList(AllocatorManager.AllocatorHandle allocator) : this(1, allocator)
        {
        }

        public NativeList(int initialCapacity, AllocatorManager.AllocatorHandle allocator)
        {
            CollectionHelper.CheckAllocator(allocator);
            CheckInitialCapacity(initialCapacity);
            m_ListData = UnsafeList<T>.Create(initialCapacity, allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            m_Safety = CollectionHelper.CreateSafetyHandle(allocator);
            AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
            AtomicSafetyHandle.SetBumpSecondaryVersionOnScheduleWrite(m_Safety, true);
#endif
        }

        public T this[int index]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                CheckRead();
                CollectionHelper.CheckIndexInRange(index, m_ListData->m_length);
                return m_ListData->Ptr[index];
            }
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            set
            {
                CheckWrite();
                CollectionHelper.CheckIndexInRange(index, m_ListData->m_length);
                m_ListData->Ptr[index] = value;
            }
        }

        public ref T ElementAt(int index)
        {
            CheckWrite();
            return ref m_ListData->ElementAt(index);
        }

        public int Length
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            readonly get
            {
                CheckRead();
                return m_ListData->m_length;
            }
            set
            {
                CheckResize();
                m_ListData->Length = value;
            }
        }

        public int Capacity
        {
            readonly get
            {
                CheckRead();
                return m_ListData->m_capacity;
            }
            set
            {
                CheckResize();
                m_ListData->SetCapacity(value);
            }
        }

        public readonly bool IsCreated => m_ListData != null;

        public readonly bool IsEmpty => m_ListData == null || m_ListData->m_length == 0;

        public UnsafeList<T>* GetUnsafeList()
        {
            CheckWrite();
            return m_ListData;
        }

        public void AddNoResize(T value)
        {
            CheckWrite();
            m_ListData->AddNoResize(value);
        }

        public void AddRangeNoResize(void* ptr, int count)
        {
            CheckWrite();
            m_ListData->AddRangeNoResize(ptr, count);
        }

        public void AddRangeNoResize(NativeList<T> list)
        {
            CheckWrite();
            list.CheckRead();
            m_ListData->AddRangeNoResize(*list.m_ListData);
        }

        public void Add(in T value)
        {
            CheckResize();
            m_ListData->Add(value);
        }

        public void AddRange(NativeArray<T> array) => AddRange(array.GetUnsafeReadOnlyPtr(), array.Length);

        public void AddRange(void* ptr, int count)
        {
            CheckResize();
            m_ListData->AddRange(ptr, count);
        }

        public void AddReplicate(in T value, int count)
        {
            CheckResize();
            m_ListData->AddReplicate(value, count);
        }

        public void InsertRangeWithBeginEnd(int begin, int end)
        {
            CheckResize();
            m_ListData->InsertRangeWithBeginEnd(begin, end);
        }

        public void InsertRange(int index, int count) => InsertRangeWithBeginEnd(index, index + count);

        public void RemoveAtSwapBack(int index)
        {
            CheckWrite();
            m_ListData->RemoveAtSwapBack(index);
        }

        public void RemoveRangeSwapBack(int index, int count)
        {
            CheckWrite();
            m_ListData->RemoveRangeSwapBack(index, count);
        }

        public void RemoveAt(int index)
        {
            CheckWrite();
            m_ListData->RemoveAt(index);
        }

        public void RemoveRange(int index, int count)
        {
            CheckWrite();
            m_ListData->RemoveRange(index, count);
        }

        public void Clear()
        {
            CheckResize();
            m_ListData->Clear();
        }

        public void Resize(int length, NativeArrayOptions options)
        {
            CheckResize();
            m_ListData->Resize(length, options);
        }

        public void ResizeUninitialized(int length) => Resize(length, NativeArrayOptions.UninitializedMemory);

        public void SetCapacity(int capacity)
        {
            CheckResize();
            m_ListData->SetCapacity(capacity);
        }

        public void TrimExcess()
        {
            CheckResize();
            m_ListData->TrimExcess();
        }

#if !UNITY_6000_4_OR_NEWER
        public void CopyFrom(in NativeArray<T> other)
        {
            CheckResize();
            m_ListData->Clear();
            m_ListData->AddRange(other.GetUnsafeReadOnlyPtr(), other.Length);
        }

        public void CopyFrom(in NativeList<T> other)
        {
            CheckResize();
            other.CheckRead();
            m_ListData->Clear();
            m_ListData->AddRange(*other.m_ListData);
        }
#endif

        public NativeArray<T> ToArray(AllocatorManager.AllocatorHandle allocator)
        {
            NativeArray<T> array = CollectionHelper.CreateNativeArray<T>(Length, allocator,
                NativeArrayOptions.UninitializedMemory);
            UnsafeUtility.MemCpy(array.m_Buffer, m_ListData->Ptr, (long)Length * sizeof(T));
            return array;
        }

        /// <summary>A view of the elements there are now; it ends when the list may have moved them.</summary>
        public NativeArray<T> AsArray()
        {
            NativeArray<T> array = NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>(m_ListData->Ptr,
                m_ListData->m_length, Allocator.None);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckGetSecondaryDataPointerAndThrow(m_Safety);
            array.m_Safety = m_Safety;
            AtomicSafetyHandle.UseSecondaryVersion(ref array.m_Safety);
#endif
            return array;
        }

        /// <summary>An array for a job, of the elements that the list has when the job runs.</summary>
        public NativeArray<T> AsDeferredJobArray()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
            JobPatch.NoteDeferredArray();
            NativeArray<T> array = NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>((byte*)m_ListData + 1, 0,
                Allocator.Invalid);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            array.m_Safety = m_Safety;
#endif
            return array;
        }

        public NativeArray<T>.ReadOnly AsReadOnly() => AsArray().AsReadOnly();

        public NativeArray<T>.ReadOnly AsParallelReader() => AsArray().AsReadOnly();

        public ParallelWriter AsParallelWriter()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            return new ParallelWriter(m_ListData, m_Safety);
#else
            return new ParallelWriter(m_ListData);
#endif
        }

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
            UnsafeList<T>.Destroy(m_ListData);
            m_ListData = null;
        }

        public JobHandle Dispose(JobHandle inputDeps)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (!AtomicSafetyHandle.IsDefaultValue(m_Safety))
                AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
            if (!IsCreated)
                return inputDeps;
            JobHandle disposed = new DisposeJob { Data = new DisposeData(this) }.Schedule(inputDeps);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.Release(m_Safety);
#endif
            m_ListData = null;
            return disposed;
        }

        public NativeArray<T>.Enumerator GetEnumerator()
        {
            NativeArray<T> array = AsArray();
            return new NativeArray<T>.Enumerator(ref array);
        }

        IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

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

        // What may move the elements ends the views of them.
        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        readonly void CheckResize()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckWriteAndBumpSecondaryVersion(m_Safety);
#endif
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        static void CheckInitialCapacity(int initialCapacity)
        {
            if (initialCapacity < 0)
                throw new ArgumentOutOfRangeException(nameof(initialCapacity), "Capacity must be >= 0");
        }

        [NativeContainer]
        [NativeContainerIsAtomicWriteOnly]
        public struct ParallelWriter
        {
            [NativeDisableUnsafePtrRestriction]
            public UnsafeList<T>* ListData;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;

            internal ParallelWriter(UnsafeList<T>* listData, AtomicSafetyHandle safety)
            {
                ListData = listData;
                m_Safety = safety;
            }
#else
            internal ParallelWriter(UnsafeList<T>* listData)
            {
                ListData = listData;
            }
#endif

            public readonly void* Ptr => ListData->Ptr;

            public void AddNoResize(T value)
            {
                CheckWrite();
                int at = ParallelAppend.Reserve(ref ListData->m_length, ListData->m_capacity, 1);
                ListData->Ptr[at] = value;
            }

            public void AddRangeNoResize(void* ptr, int count)
            {
                CheckWrite();
                int at = ParallelAppend.Reserve(ref ListData->m_length, ListData->m_capacity, count);
                UnsafeUtility.MemCpy(ListData->Ptr + at, ptr, (long)count * sizeof(T));
            }

            public void AddRangeNoResize(UnsafeList<T> list) => AddRangeNoResize(list.Ptr, list.m_length);

            public void AddRangeNoResize(NativeList<T> list)
            {
                list.CheckRead();
                AddRangeNoResize(*list.m_ListData);
            }

            [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
            readonly void CheckWrite()
            {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
#endif
            }
        }

        [NativeContainer]
        struct DisposeData
        {
            [NativeDisableUnsafePtrRestriction]
            internal UnsafeList<T>* m_ListData;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;
#endif

            internal DisposeData(NativeList<T> list)
            {
                m_ListData = list.m_ListData;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                m_Safety = list.m_Safety;
#endif
            }
        }

        struct DisposeJob : IJob
        {
            internal DisposeData Data;

            public void Execute() => UnsafeList<T>.Destroy(Data.m_ListData);
        }
    }
}
