using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Collections
{
    public static unsafe class CollectionHelper
    {
        public const int CacheLineSize = 64;

        public static int Log2Floor(int value)
        {
            int log = -1;
            for (uint bits = (uint)value; bits != 0; bits >>= 1)
                log++;
            return Math.Max(log, 0);
        }

        public static int Log2Ceil(int value) => value <= 1 ? 0 : Log2Floor(value - 1) + 1;

        public static bool IsPowerOfTwo(int value) => (value & (value - 1)) == 0;

        public static int Align(int size, int alignmentPowerOfTwo) =>
            alignmentPowerOfTwo == 0 ? size : (size + alignmentPowerOfTwo - 1) & ~(alignmentPowerOfTwo - 1);

        public static long Align(long size, int alignmentPowerOfTwo) =>
            alignmentPowerOfTwo == 0 ? size : (size + alignmentPowerOfTwo - 1) & ~(alignmentPowerOfTwo - 1L);

        public static ulong Align(ulong size, ulong alignmentPowerOfTwo) =>
            alignmentPowerOfTwo == 0 ? size : (size + alignmentPowerOfTwo - 1) & ~(alignmentPowerOfTwo - 1);

        public static bool IsAligned(void* p, int alignmentPowerOfTwo) => ((ulong)p & ((ulong)alignmentPowerOfTwo - 1)) == 0;

        public static bool IsAligned(ulong offset, int alignmentPowerOfTwo) =>
            (offset & ((ulong)alignmentPowerOfTwo - 1)) == 0;

        /// <summary>Weak, but the same bytes give the same number.</summary>
        public static uint Hash(void* ptr, int bytes)
        {
            uint hash = 5381;
            for (int i = 0; i < bytes; i++)
                hash = hash * 33 + ((byte*)ptr)[i];
            return hash;
        }

        public static NativeArray<T> CreateNativeArray<T>(int length, AllocatorManager.AllocatorHandle allocator,
            NativeArrayOptions options = NativeArrayOptions.ClearMemory) where T : unmanaged =>
            new NativeArray<T>(length, allocator.ToAllocator, options);

        public static NativeArray<T> CreateNativeArray<T>(NativeArray<T> array, AllocatorManager.AllocatorHandle allocator)
            where T : unmanaged => new NativeArray<T>(array, allocator.ToAllocator);

        public static NativeArray<T> CreateNativeArray<T>(T[] array, AllocatorManager.AllocatorHandle allocator)
            where T : unmanaged => new NativeArray<T>(array, allocator.ToAllocator);

        public static void Dispose<T>(NativeArray<T> nativeArray) where T : unmanaged => nativeArray.Dispose();

        public static void DisposeNativeArray<T>(NativeArray<T> nativeArray, AllocatorManager.AllocatorHandle allocator)
            where T : unmanaged => nativeArray.Dispose();

        /// <summary>Wraps memory that lies elsewhere, with a safety handle in the test build, which the caller
        /// releases.</summary>
        public static NativeArray<T> ConvertExistingDataToNativeArray<T>(void* dataPointer, int length,
            AllocatorManager.AllocatorHandle allocator, bool setTempMemoryHandle = false) where T : unmanaged
        {
            NativeArray<T> array =
                NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>(dataPointer, length, allocator.ToAllocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (setTempMemoryHandle)
                array.m_Safety = AtomicSafetyHandle.GetTempMemoryHandle();
#endif
            return array;
        }

        public static AtomicSafetyHandle CreateSafetyHandle(AllocatorManager.AllocatorHandle allocator) =>
            allocator.ToAllocator == Allocator.Temp ? AtomicSafetyHandle.GetTempMemoryHandle() : AtomicSafetyHandle.Create();

        public static void DisposeSafetyHandle(ref AtomicSafetyHandle handle)
        {
            AtomicSafetyHandle.CheckDeallocateAndThrow(handle);
            AtomicSafetyHandle.Release(handle);
        }

        public static void SetStaticSafetyId<T>(ref AtomicSafetyHandle handle, ref int sharedStaticId)
        {
            if (sharedStaticId == 0)
                sharedStaticId = AtomicSafetyHandle.NewStaticSafetyId<T>();
            AtomicSafetyHandle.SetStaticSafetyId(ref handle, sharedStaticId);
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal static void CheckIndexInRange(int index, int length)
        {
            if ((uint)index >= (uint)length)
                throw new IndexOutOfRangeException($"Index {index} is out of range in container of '{length}' Length.");
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        internal static void CheckAllocator(AllocatorManager.AllocatorHandle allocator)
        {
            if (allocator.Index <= (ushort)Allocator.None)
                throw new ArgumentException($"Allocator {allocator.ToAllocator} must not be None or Invalid");
        }
    }
}
