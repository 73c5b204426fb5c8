using System.Collections;
using StandIns.Jobs;

namespace Unity.Collections;

[NativeContainer]
[NativeContainerSupportsMinMaxWriteRestriction]
[NativeContainerSupportsDeallocateOnJobCompletion]
[DebuggerDisplay("Length = {Length}")]
public unsafe partial struct NativeArray<T> : IDisposable, IEnumerable<T>, IEquatable<NativeArray<T>> where T : struct
{
    [NativeDisableUnsafePtrRestriction] internal void* m_Buffer;
    internal int m_Length;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    internal int m_MinIndex;
    internal int m_MaxIndex;
    internal AtomicSafetyHandle m_Safety;
    static readonly int s_name = SafetyNames.IdOf(SafetyNames.Of(typeof(NativeArray<T>)));
#endif
    internal Allocator m_AllocatorLabel;

    public NativeArray(int length, Allocator allocator, NativeArrayOptions options = NativeArrayOptions.ClearMemory)
    {
        Allocate(length, allocator, out this);
        if ((options & NativeArrayOptions.ClearMemory) != 0)
            UnsafeUtility.MemClear(m_Buffer, (long)length * SystemUnsafe.SizeOf<T>());
    }

    public NativeArray(T[] array, Allocator allocator)
    {
        if (array == null)
            throw new ArgumentNullException(nameof(array));
        Allocate(array.Length, allocator, out this);
        Copy(array, this);
    }

    public NativeArray(NativeArray<T> array, Allocator allocator)
    {
        array.CheckRead();
        Allocate(array.Length, allocator, out this);
        Copy(array, 0, this, 0, array.Length);
    }

    public int Length
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => m_Length;
    }

    public bool IsCreated
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => m_Buffer != null;
    }

    public T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            CheckElementRead(index);
            return SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(m_Buffer), index);
        }
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        [WriteAccessRequired]
        set
        {
            CheckElementWrite(index);
            SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(m_Buffer), index) = value;
        }
    }

    [WriteAccessRequired]
    public void Dispose()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (m_AllocatorLabel != Allocator.None && !AtomicSafetyHandle.IsDefaultValue(m_Safety))
            AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
        if (!IsCreated)
            return;
        CheckDisposable();
        if (m_AllocatorLabel > Allocator.None)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckDeallocateAndThrow(m_Safety);
            AtomicSafetyHandle.Release(m_Safety);
#endif
            UnsafeUtility.FreeTracked(m_Buffer, m_AllocatorLabel);
            m_AllocatorLabel = Allocator.Invalid;
        }
        m_Buffer = null;
    }

    /// <summary>Frees the memory in a job that runs when <paramref name="inputDeps"/> are done.</summary>
    public JobHandle Dispose(JobHandle inputDeps)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (m_AllocatorLabel != Allocator.None && !AtomicSafetyHandle.IsDefaultValue(m_Safety))
            AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
        if (!IsCreated)
            return inputDeps;
        CheckDisposable();
        JobHandle disposed = inputDeps;
        if (m_AllocatorLabel > Allocator.None)
        {
            var job = new NativeArrayDisposeJob
            {
                Data = new NativeArrayDispose
                {
                    m_Buffer = m_Buffer,
                    m_AllocatorLabel = m_AllocatorLabel,
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                    m_Safety = m_Safety,
#endif
                },
            };
            disposed = job.Schedule(inputDeps);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.Release(m_Safety);
#endif
            m_AllocatorLabel = Allocator.Invalid;
        }
        m_Buffer = null;
        return disposed;
    }

    [WriteAccessRequired]
    public void CopyFrom(T[] array) => Copy(array, this);

    [WriteAccessRequired]
    public void CopyFrom(NativeArray<T> array) => Copy(array, this);

    public void CopyTo(T[] array) => Copy(this, array);
    public void CopyTo(NativeArray<T> array) => Copy(this, array);

    public T[] ToArray()
    {
        var array = new T[Length];
        Copy(this, array, Length);
        return array;
    }

    public ReadOnly AsReadOnly()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        return new ReadOnly(m_Buffer, m_Length, m_Safety);
#else
        return new ReadOnly(m_Buffer, m_Length);
#endif
    }

    public readonly Span<T> AsSpan()
    {
        CheckWrite();
        return new Span<T>(m_Buffer, m_Length);
    }

    public readonly ReadOnlySpan<T> AsReadOnlySpan()
    {
        CheckRead();
        return new ReadOnlySpan<T>(m_Buffer, m_Length);
    }

    public static implicit operator Span<T>(in NativeArray<T> source) => source.AsSpan();
    public static implicit operator ReadOnlySpan<T>(in NativeArray<T> source) => source.AsReadOnlySpan();

    public NativeArray<T> GetSubArray(int start, int length)
    {
        CheckSubArray(start, length);
        NativeArray<T> part = default;
        part.m_Buffer = (byte*)m_Buffer + (long)start * SystemUnsafe.SizeOf<T>();
        part.m_Length = length;
        part.m_AllocatorLabel = Allocator.None;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        part.m_MaxIndex = length - 1;
        part.m_Safety = m_Safety;
#endif
        return part;
    }

    public NativeArray<U> Reinterpret<U>() where U : struct
    {
        CheckSameSize<U>();
        return InternalReinterpret<U>(m_Length);
    }

    public NativeArray<U> Reinterpret<U>(int expectedTypeSize) where U : struct
    {
        long bytes = (long)m_Length * SystemUnsafe.SizeOf<T>();
        long length = bytes / SystemUnsafe.SizeOf<U>();
        CheckReinterpret<U>(expectedTypeSize, bytes, length);
        return InternalReinterpret<U>((int)length);
    }

    public U ReinterpretLoad<U>(int sourceIndex) where U : struct
    {
        CheckReinterpretRange<U>(sourceIndex, write: false);
        return SystemUnsafe.ReadUnaligned<U>((byte*)m_Buffer + (long)sourceIndex * SystemUnsafe.SizeOf<T>());
    }

    public Enumerator GetEnumerator() => new Enumerator(ref this);
    IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();
    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    public bool Equals(NativeArray<T> other) => m_Buffer == other.m_Buffer && m_Length == other.m_Length;
    public override bool Equals(object obj) => obj is NativeArray<T> other && Equals(other);
    public override int GetHashCode() => ((int)(long)m_Buffer * 397) ^ m_Length;
    public static bool operator ==(NativeArray<T> left, NativeArray<T> right) => left.Equals(right);
    public static bool operator !=(NativeArray<T> left, NativeArray<T> right) => !left.Equals(right);

    static void Allocate(int length, Allocator allocator, out NativeArray<T> array)
    {
        CheckAllocation(length, allocator);
        array = default;
        array.m_Buffer = UnsafeUtility.MallocTracked((long)length * SystemUnsafe.SizeOf<T>(), UnsafeUtility.AlignOf<T>(),
            allocator, 0);
        array.m_Length = length;
        array.m_AllocatorLabel = allocator;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        array.m_MaxIndex = length - 1;
        array.m_Safety = allocator == Allocator.Temp ? AtomicSafetyHandle.GetTempMemoryHandle() : AtomicSafetyHandle.Create();
        array.m_Safety.m_Name = s_name;
#endif
    }

    NativeArray<U> InternalReinterpret<U>(int length) where U : struct
    {
        NativeArray<U> array = default;
        array.m_Buffer = m_Buffer;
        array.m_Length = length;
        array.m_AllocatorLabel = m_AllocatorLabel;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        array.m_MaxIndex = length - 1;
        array.m_Safety = m_Safety;
#endif
        return array;
    }
}
