namespace Unity.Burst
{
    /// <summary>What Burst's own library of IL has.</summary>
    static unsafe class Unsafe
    {
        public static void CopyBlock(void* destination, void* source, uint byteCount) =>
            System.Runtime.CompilerServices.Unsafe.CopyBlock(destination, source, byteCount);
        public static void CopyBlock(ref byte destination, ref byte source, uint byteCount) =>
            System.Runtime.CompilerServices.Unsafe.CopyBlock(ref destination, ref source, byteCount);
        public static ref T AsRef<T>(void* source) => ref System.Runtime.CompilerServices.Unsafe.AsRef<T>(source);
    }
}
