using System.Collections;

namespace Unity.Collections
{
    [NativeContainer]
    [DebuggerDisplay("Length = {Length}, Capacity = {Capacity}")]
    public unsafe struct NativeList<T> : IDisposable, IEnumerable<T> where T : unmanaged
    {
        [NativeDisableUnsafePtrRestriction] internal ListData<T>* m_List;
        internal AtomicSafetyHandle m_Safety;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeList<T>>();
#endif

        public NativeList(AllocatorManager.AllocatorHandle allocator) : this(1, allocator) { }

        public NativeList(int initialCapacity, AllocatorManager.AllocatorHandle allocator)
        {
            m_List = ListData<T>.Create(initialCapacity, allocator);
            m_Safety = ContainerChecks.CreateSafetyHandle(allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
            AtomicSafetyHandle.SetBumpSecondaryVersionOnScheduleWrite(m_Safety, true);
#endif
        }

        public T this[int index]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
                ContainerChecks.CheckIndexInRange(index, m_List->Length);
                return m_List->Items[index];
            }
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            set
            {
                AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
                ContainerChecks.CheckIndexInRange(index, m_List->Length);
                m_List->Items[index] = value;
            }
        }

        public ref T ElementAt(int index)
        {
            AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
            ContainerChecks.CheckIndexInRange(index, m_List->Length);
            return ref m_List->Items[index];
        }

        public readonly int Length
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
                return m_List->Length;
            }
        }

        public int Capacity
        {
            readonly get
            {
                AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
                return m_List->Capacity;
            }
            set => SetCapacity(value);
        }

        public readonly bool IsCreated => m_List != null;

        // What may move or remove elements ends the views of them.
        public void Add(in T value)
        {
            AtomicSafetyHandle.CheckWriteAndBumpSecondaryVersion(m_Safety);
            m_List->Add(in value);
        }

        public void AddRange(NativeArray<T> array) => AddRange(array.GetUnsafeReadOnlyPtr(), array.Length);

        public void AddRange(void* ptr, int count)
        {
            AtomicSafetyHandle.CheckWriteAndBumpSecondaryVersion(m_Safety);
            m_List->AddRange(ptr, count);
        }

        public void RemoveAtSwapBack(int index)
        {
            AtomicSafetyHandle.CheckWriteAndBumpSecondaryVersion(m_Safety);
            m_List->RemoveAtSwapBack(index);
        }

        public void RemoveAt(int index)
        {
            AtomicSafetyHandle.CheckWriteAndBumpSecondaryVersion(m_Safety);
            m_List->RemoveAt(index);
        }

        public void Clear() => ResizeUninitialized(0);

        public void Resize(int length, NativeArrayOptions options)
        {
            AtomicSafetyHandle.CheckWriteAndBumpSecondaryVersion(m_Safety);
            m_List->Resize(length, options);
        }

        public void ResizeUninitialized(int length) => Resize(length, NativeArrayOptions.UninitializedMemory);

        public void SetCapacity(int capacity)
        {
            AtomicSafetyHandle.CheckWriteAndBumpSecondaryVersion(m_Safety);
            m_List->SetCapacity(capacity);
        }

        /// <summary>A view of the elements there are now; it ends when the list may have moved them.</summary>
        public NativeArray<T> AsArray()
        {
            AtomicSafetyHandle.CheckGetSecondaryDataPointerAndThrow(m_Safety);
            NativeArray<T> array = NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>(m_List->Items, m_List->Length,
                Allocator.None);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            array.m_Safety = m_Safety;
            AtomicSafetyHandle.UseSecondaryVersion(ref array.m_Safety);
#endif
            return array;
        }

        public void Dispose()
        {
            if (!ContainerChecks.TryRelease(m_Safety, IsCreated))
                return;
            ListData<T>.Destroy(m_List);
            m_List = null;
        }

        public NativeArray<T>.Enumerator GetEnumerator()
        {
            NativeArray<T> array = AsArray();
            return new NativeArray<T>.Enumerator(ref array);
        }

        // The interface is there for collection initializers alone.
        IEnumerator<T> IEnumerable<T>.GetEnumerator() => throw new NotImplementedException();

        IEnumerator IEnumerable.GetEnumerator() => throw new NotImplementedException();
    }
}

namespace Unity.Collections.LowLevel.Unsafe
{
    public static unsafe class NativeListUnsafeUtility
    {
        public static T* GetUnsafePtr<T>(this NativeList<T> list) where T : unmanaged
        {
            AtomicSafetyHandle.CheckWriteAndThrow(list.m_Safety);
            return list.m_List->Items;
        }

        public static T* GetUnsafeReadOnlyPtr<T>(this NativeList<T> list) where T : unmanaged
        {
            AtomicSafetyHandle.CheckReadAndThrow(list.m_Safety);
            return list.m_List->Items;
        }
    }
}
