namespace StandIns.Memory;

static unsafe class NativeHeap
{
    // Unity's allocators give at least 16; vectors of 32 bytes then need no care either.
    const int MinAlignment = 32;
    const int MaxSpoiled = 1 << 20;

#if NET
    // By itself the C library takes ever larger blocks from its heap, where what is freed stays with the process: a build in
    // 160 MiB kept up to 70 MB so.
    const int MmapThreshold = -3;
    const int MinBytesFromTheSystem = 4 << 20;

    static NativeHeap()
    {
        if (!OperatingSystem.IsLinux())
            return;
        try
        {
            SetMallocOption(MmapThreshold, MinBytesFromTheSystem);
        }
        catch (Exception e) when (e is EntryPointNotFoundException || e is DllNotFoundException)
        {
            // Another C library, with a way of its own.
        }
    }

    [DllImport("libc", EntryPoint = "mallopt")] static extern int SetMallocOption(int option, int value);
#endif

    internal static void* Allocate(long size, int alignment)
    {
        if (size < 0)
            throw new ArgumentOutOfRangeException(nameof(size), size, "An allocation cannot have a negative size.");
        if (alignment <= 0 || (alignment & (alignment - 1)) != 0)
            throw new ArgumentException($"An alignment must be a power of two, not {alignment}.", nameof(alignment));
#if NET
        void* aligned = NativeMemory.AlignedAlloc((nuint)Math.Max(size, 1), (nuint)Math.Max(alignment, MinAlignment));
        Spoil(aligned, size);
        return aligned;
#else
        // The block's own address lies before what is handed out.
        alignment = Math.Max(alignment, MinAlignment);
        long block = (long)Marshal.AllocHGlobal(new IntPtr(size + alignment + sizeof(long)));
        long* aligned = (long*)((block + sizeof(long) + alignment - 1) & -alignment);
        aligned[-1] = block;
        Spoil(aligned, size);
        return aligned;
#endif
    }

    // What nobody cleared is not zero, as it often is by chance; of large blocks, whose pages should not all be touched, the
    // beginning does.
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void Spoil(void* memory, long size) => new Span<byte>(memory, (int)Math.Min(size, MaxSpoiled)).Fill(0xCD);

    internal static void Free(void* memory)
    {
#if NET
        NativeMemory.AlignedFree(memory);
#else
        if (memory != null)
            Marshal.FreeHGlobal((IntPtr)((long*)memory)[-1]);
#endif
    }
}
