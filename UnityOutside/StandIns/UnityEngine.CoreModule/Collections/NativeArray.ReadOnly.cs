using System.Collections;
namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    [NativeContainer]
    [NativeContainerIsReadOnly]
    [DebuggerDisplay("Length = {Length}")]
    public partial struct ReadOnly : IEnumerable<T>
    {
        [NativeDisableUnsafePtrRestriction] internal void* m_Buffer;
        internal int m_Length;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        internal AtomicSafetyHandle m_Safety;

        internal ReadOnly(void* buffer, int length, AtomicSafetyHandle safety)
        {
            m_Buffer = buffer;
            m_Length = length;
            m_Safety = safety;
        }
#else
        internal ReadOnly(void* buffer, int length)
        {
            m_Buffer = buffer;
            m_Length = length;
        }
#endif

        public int Length
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => m_Length;
        }

        public T this[int index]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                CheckElement(index);
                return SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(m_Buffer), index);
            }
        }

        public NativeArray<U>.ReadOnly Reinterpret<U>() where U : struct
        {
            CheckSameSize<U>();
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            return new NativeArray<U>.ReadOnly(m_Buffer, m_Length, m_Safety);
#else
            return new NativeArray<U>.ReadOnly(m_Buffer, m_Length);
#endif
        }

        public readonly ReadOnlySpan<T> AsReadOnlySpan()
        {
            CheckRead();
            return new ReadOnlySpan<T>(m_Buffer, m_Length);
        }

        public static implicit operator ReadOnlySpan<T>(in ReadOnly source) => source.AsReadOnlySpan();
        public Enumerator GetEnumerator() => new Enumerator(this);
        IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();
        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        internal readonly void CheckRead()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        readonly void CheckElement(int index)
        {
            if ((uint)index >= (uint)m_Length)
                throw new IndexOutOfRangeException($"Index {index} is out of range (must be between 0 and {m_Length - 1}).");
            CheckRead();
        }

        public struct Enumerator : IEnumerator<T>
        {
            ReadOnly m_Array;
            int m_Index;

            public Enumerator(in ReadOnly array)
            {
                m_Array = array;
                m_Index = -1;
            }

            public T Current => m_Array[m_Index];
            object IEnumerator.Current => Current;

            public bool MoveNext() => ++m_Index < m_Array.Length;
            public void Reset() => m_Index = -1;
            public void Dispose() { }
        }
    }

    public struct Enumerator : IEnumerator<T>
    {
        NativeArray<T> m_Array;
        int m_Index;

        public Enumerator(ref NativeArray<T> array)
        {
            m_Array = array;
            m_Index = -1;
        }

        public T Current => m_Array[m_Index];
        object IEnumerator.Current => Current;

        public bool MoveNext() => ++m_Index < m_Array.Length;
        public void Reset() => m_Index = -1;
        public void Dispose() { }
    }
}
