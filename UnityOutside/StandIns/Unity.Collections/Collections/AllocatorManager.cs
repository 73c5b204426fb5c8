namespace Unity.Collections;

public static unsafe class AllocatorManager
{
    /// <summary>Unity's own allocators by number; allocators of one's own are not here.</summary>
    public struct AllocatorHandle
    {
        public ushort Index;

        public Allocator ToAllocator => (Allocator)Index;

        public static implicit operator AllocatorHandle(Allocator a) => new AllocatorHandle { Index = (ushort)a };
    }

    internal static T* Allocate<T>(AllocatorHandle handle, int items = 1) where T : unmanaged
    {
        CheckHandle(handle);
        return (T*)UnsafeUtility.MallocTracked((long)sizeof(T) * items, UnsafeUtility.AlignOf<T>(), handle.ToAllocator, 0);
    }

    internal static void Free(AllocatorHandle handle, void* pointer)
    {
        CheckHandle(handle);
        UnsafeUtility.FreeTracked(pointer, handle.ToAllocator);
    }

    static void CheckHandle(AllocatorHandle handle)
    {
        if (handle.ToAllocator <= Allocator.None)
            throw new ArgumentException($"Allocator {handle.ToAllocator} must not be None or Invalid");
        if (handle.ToAllocator >= Allocator.FirstUserIndex)
            throw new NotSupportedException("Custom allocators are not part of the headless stand-ins.");
    }
}
