using System.Runtime.CompilerServices;
using SystemUnsafe = System.Runtime.CompilerServices.Unsafe;

namespace Unity.Collections.LowLevel.Unsafe
{
    public static unsafe class UnsafeUtilityExtensions
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void* AddressOf<T>(in T value) where T : unmanaged =>
            SystemUnsafe.AsPointer(ref SystemUnsafe.AsRef(in value));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ref T AsRef<T>(in T value) where T : unmanaged => ref SystemUnsafe.AsRef(in value);
    }
}
