namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    public static void Copy(NativeArray<T> src, NativeArray<T> dst)
    {
        CheckSameLength(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(ReadOnly src, NativeArray<T> dst)
    {
        CheckSameLength(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(T[] src, NativeArray<T> dst)
    {
        CheckSameLength(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(NativeArray<T> src, T[] dst)
    {
        CheckSameLength(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(ReadOnly src, T[] dst)
    {
        CheckSameLength(src.Length, dst.Length);
        Copy(src, 0, dst, 0, src.Length);
    }

    public static void Copy(NativeArray<T> src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);
    public static void Copy(ReadOnly src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);
    public static void Copy(T[] src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);
    public static void Copy(NativeArray<T> src, T[] dst, int length) => Copy(src, 0, dst, 0, length);
    public static void Copy(ReadOnly src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(NativeArray<T> src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
    {
        src.CheckRead();
        dst.CheckWrite();
        CheckRanges(src.Length, srcIndex, dst.Length, dstIndex, length);
        CopyElements(src.m_Buffer, srcIndex, dst.m_Buffer, dstIndex, length);
    }

    public static void Copy(ReadOnly src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
    {
        src.CheckRead();
        dst.CheckWrite();
        CheckRanges(src.Length, srcIndex, dst.Length, dstIndex, length);
        CopyElements(src.m_Buffer, srcIndex, dst.m_Buffer, dstIndex, length);
    }

    public static void Copy(T[] src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
    {
        dst.CheckWrite();
        CheckManaged(src);
        CheckRanges(src.Length, srcIndex, dst.Length, dstIndex, length);
        new ReadOnlySpan<T>(src, srcIndex, length).CopyTo(new Span<T>(dst.m_Buffer, dst.m_Length).Slice(dstIndex));
    }

    public static void Copy(NativeArray<T> src, int srcIndex, T[] dst, int dstIndex, int length)
    {
        src.CheckRead();
        CheckManaged(dst);
        CheckRanges(src.Length, srcIndex, dst.Length, dstIndex, length);
        new ReadOnlySpan<T>(src.m_Buffer, src.m_Length).Slice(srcIndex, length).CopyTo(new Span<T>(dst, dstIndex, length));
    }

    public static void Copy(ReadOnly src, int srcIndex, T[] dst, int dstIndex, int length)
    {
        src.CheckRead();
        CheckManaged(dst);
        CheckRanges(src.Length, srcIndex, dst.Length, dstIndex, length);
        new ReadOnlySpan<T>(src.m_Buffer, src.m_Length).Slice(srcIndex, length).CopyTo(new Span<T>(dst, dstIndex, length));
    }

    static void CopyElements(void* src, int srcIndex, void* dst, int dstIndex, int length)
    {
        long size = SystemUnsafe.SizeOf<T>();
        UnsafeUtility.MemCpy((byte*)dst + dstIndex * size, (byte*)src + srcIndex * size, length * size);
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void CheckSameLength(int srcLength, int dstLength)
    {
        if (srcLength != dstLength)
            throw new ArgumentException("source and destination length must be the same");
    }

    static void CheckManaged(T[] array)
    {
        if (array == null)
            throw new ArgumentNullException(nameof(array));
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void CheckRanges(int srcLength, int srcIndex, int dstLength, int dstIndex, int length)
    {
        if (length < 0)
            throw new ArgumentOutOfRangeException(nameof(length), "length must be equal or greater than zero.");
        if (srcIndex < 0 || srcIndex > srcLength || (srcIndex == srcLength && srcLength > 0))
            throw new ArgumentOutOfRangeException(nameof(srcIndex),
                "srcIndex is outside the range of valid indexes for the source NativeArray.");
        if (dstIndex < 0 || dstIndex > dstLength || (dstIndex == dstLength && dstLength > 0))
            throw new ArgumentOutOfRangeException(nameof(dstIndex),
                "dstIndex is outside the range of valid indexes for the destination NativeArray.");
        if ((long)srcIndex + length > srcLength)
            throw new ArgumentException(
                "length is greater than the number of elements from srcIndex to the end of the source NativeArray.",
                nameof(length));
        if ((long)dstIndex + length > dstLength)
            throw new ArgumentException(
                "length is greater than the number of elements from dstIndex to the end of the destination NativeArray.",
                nameof(length));
        // Unity multiplies these in int, and copies from or to elsewhere then; parts of an array it finds in long.
        if ((long)Math.Max(Math.Max(srcIndex, dstIndex), length) * SystemUnsafe.SizeOf<T>() > int.MaxValue)
            throw new ArgumentOutOfRangeException(nameof(length), "an array is copied up to its 2^31st byte only.");
    }
}
