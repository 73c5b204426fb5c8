using System.Collections.Concurrent;

namespace Unity.Collections.LowLevel.Unsafe;

public static unsafe partial class UnsafeUtility
{
    const int HeaderBytes = 8;

    static readonly MethodInfo s_sizeOf = typeof(SystemUnsafe).GetMethod(nameof(SystemUnsafe.SizeOf));
    static readonly MethodInfo s_isManaged =
        typeof(RuntimeHelpers).GetMethod(nameof(RuntimeHelpers.IsReferenceOrContainsReferences));
    static readonly ConcurrentDictionary<Type, int> s_sizes = new ConcurrentDictionary<Type, int>();
    static readonly ConcurrentDictionary<ulong, GCHandle> s_pinned = new ConcurrentDictionary<ulong, GCHandle>();
    static long s_lastPin;

    public static ref U As<T, U>(ref T from) => ref SystemUnsafe.As<T, U>(ref from);
    public static ref T AsRef<T>(void* ptr) where T : struct => ref SystemUnsafe.AsRef<T>(ptr);

    public static ref T ArrayElementAsRef<T>(void* ptr, int index) where T : struct =>
        ref SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(ptr), index);

    public static T ReadArrayElementWithStride<T>(void* source, int index, int stride) =>
        SystemUnsafe.Read<T>((byte*)source + (long)index * stride);

    public static void WriteArrayElementWithStride<T>(void* destination, int index, int stride, T value) =>
        SystemUnsafe.Write((byte*)destination + (long)index * stride, value);

    public static void CopyPtrToStructure<T>(void* ptr, out T output) where T : struct => output = SystemUnsafe.Read<T>(ptr);
    public static void CopyStructureToPtr<T>(ref T input, void* ptr) where T : struct => SystemUnsafe.Write(ptr, input);

    public static void MemCpyReplicate(void* destination, void* source, int size, int count) =>
        MemCpyStride(destination, size, source, 0, size, count);

    public static void MemCpyStride(void* destination, int destinationStride, void* source, int sourceStride, int elementSize,
        int count)
    {
        for (int i = 0; i < count; i++)
            MemCpy((byte*)destination + (long)i * destinationStride, (byte*)source + (long)i * sourceStride, elementSize);
    }

    public static void MemSwap(void* ptr1, void* ptr2, long size)
    {
        for (long i = 0; i < size; i++)
            (((byte*)ptr1)[i], ((byte*)ptr2)[i]) = (((byte*)ptr2)[i], ((byte*)ptr1)[i]);
    }

    public static int SizeOf(Type type) => s_sizes.GetOrAdd(type, t => (int)s_sizeOf.MakeGenericMethod(t).Invoke(null, null));

    public static bool IsUnmanaged(Type type) => type.IsValueType && !type.ContainsGenericParameters
        && !(bool)s_isManaged.MakeGenericMethod(type).Invoke(null, null);

    public static bool IsNativeContainerType<T>() => IsNativeContainerType(typeof(T));
    public static bool IsNativeContainerType(Type type) => ContainerType.Is(type);
    internal static string GetReasonForTypeNonBlittable(Type t) => $"{t} holds references.";
    internal static string GetReasonForTypeNonBlittableImpl(Type t, string name) => $"{name} {t} holds references.";

    /// <summary>Of a class, from where its header begins: CoreCLR has the offset in the low 27 bits of the second word that
    /// describes a field.</summary>
    public static int GetFieldOffset(FieldInfo field) => field.DeclaringType.IsValueType
        ? FieldOffsets.Of(field.DeclaringType, new[] { new[] { field } })[0]
        : HeaderBytes + (int)(*(uint*)(field.FieldHandle.Value + IntPtr.Size + 4) & 0x7FFFFFF);

    /// <summary>Where the object's header begins. .NET holds no object with references where it is: such a one is only kept
    /// alive, and a collection may move it.</summary>
    public static void* PinGCObjectAndGetAddress(object target, out ulong gcHandle)
    {
        gcHandle = Keep(target, target.GetType().IsValueType);
        return (byte*)SystemUnsafe.AsPointer(ref SystemUnsafe.As<Header>(target).First) - HeaderBytes;
    }

    public static void* PinGCArrayAndGetDataAddress(Array target, out ulong gcHandle)
    {
        gcHandle = Keep(target, true);
        return (void*)Marshal.UnsafeAddrOfPinnedArrayElement(target, 0);
    }

    public static void ReleaseGCObject(ulong gcHandle)
    {
        if (s_pinned.TryRemove(gcHandle, out GCHandle handle))
            handle.Free();
    }

    static ulong Keep(object target, bool pinned)
    {
        ulong number = (ulong)Interlocked.Increment(ref s_lastPin);
        s_pinned[number] = GCHandle.Alloc(target, pinned ? GCHandleType.Pinned : GCHandleType.Normal);
        return number;
    }

    sealed class Header
    {
        internal byte First;
    }
}
