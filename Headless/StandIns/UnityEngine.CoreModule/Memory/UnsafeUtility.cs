using System;
using System.Runtime.CompilerServices;
using StandIns.Memory;
using SystemUnsafe = System.Runtime.CompilerServices.Unsafe;

namespace Unity.Collections.LowLevel.Unsafe
{
    public static unsafe class UnsafeUtility
    {
        public static void* Malloc(long size, int alignment, Allocator allocator)
        {
            if (allocator == Allocator.Temp)
                return TempMemory.Allocate(size, alignment);
            CheckAllocator(allocator);
            void* memory = NativeHeap.Allocate(size, alignment);
            AllocationLedger.Add(memory, size, allocator, tracked: false);
            return memory;
        }

        public static void* MallocTracked(long size, int alignment, Allocator allocator, int callstacksToSkip)
        {
            if (allocator == Allocator.Temp)
                return TempMemory.Allocate(size, alignment);
            CheckAllocator(allocator);
            void* memory = NativeHeap.Allocate(size, alignment);
            AllocationLedger.Add(memory, size, allocator, tracked: true);
            return memory;
        }

        public static void Free(void* memory, Allocator allocator)
        {
            if (memory == null)
                return;
            if (allocator == Allocator.Temp)
            {
                TempMemory.Free(memory);
                return;
            }
            CheckAllocator(allocator);
            AllocationLedger.Remove(memory, allocator);
            NativeHeap.Free(memory);
        }

        public static void FreeTracked(void* memory, Allocator allocator) => Free(memory, allocator);

        public static bool IsValidAllocator(Allocator allocator) => allocator > Allocator.None;

        public static int CheckForLeaks() => AllocationLedger.CheckForLeaks();

        public static int ForgiveLeaks() => AllocationLedger.ForgiveLeaks();

        public static NativeLeakDetectionMode GetLeakDetectionMode() => AllocationLedger.Mode;

        public static void SetLeakDetectionMode(NativeLeakDetectionMode value) => AllocationLedger.Mode = value;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void MemCpy(void* destination, void* source, long size) =>
            Buffer.MemoryCopy(source, destination, size, size);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void MemMove(void* destination, void* source, long size) =>
            Buffer.MemoryCopy(source, destination, size, size);

        public static void MemSet(void* destination, byte value, long size)
        {
            byte* at = (byte*)destination;
            while (size > 0)
            {
                int part = (int)Math.Min(size, 1 << 30);
                new Span<byte>(at, part).Fill(value);
                at += part;
                size -= part;
            }
        }

        public static void MemClear(void* destination, long size) => MemSet(destination, 0, size);

        public static int MemCmp(void* ptr1, void* ptr2, long size)
        {
            byte* a = (byte*)ptr1;
            byte* b = (byte*)ptr2;
            while (size > 0)
            {
                int part = (int)Math.Min(size, 1 << 30);
                int order = new ReadOnlySpan<byte>(a, part).SequenceCompareTo(new ReadOnlySpan<byte>(b, part));
                if (order != 0)
                    return order;
                a += part;
                b += part;
                size -= part;
            }
            return 0;
        }

        public static void MemCpyReplicate(void* destination, void* source, int size, int count)
        {
            byte* at = (byte*)destination;
            for (int i = 0; i < count; i++, at += size)
                MemCpy(at, source, size);
        }

        public static void MemCpyStride(void* destination, int destinationStride, void* source, int sourceStride,
            int elementSize, int count)
        {
            byte* to = (byte*)destination;
            byte* from = (byte*)source;
            for (int i = 0; i < count; i++, to += destinationStride, from += sourceStride)
                MemCpy(to, from, elementSize);
        }

        public static void MemSwap(void* ptr1, void* ptr2, long size)
        {
            byte* a = (byte*)ptr1;
            byte* b = (byte*)ptr2;
            for (long i = 0; i < size; i++)
                (a[i], b[i]) = (b[i], a[i]);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int SizeOf<T>() where T : struct => SystemUnsafe.SizeOf<T>();

        public static int AlignOf<T>() where T : struct => SystemUnsafe.SizeOf<AlignOfHelper<T>>() - SystemUnsafe.SizeOf<T>();

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static T ReadArrayElement<T>(void* source, int index) =>
            SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(source), index);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void WriteArrayElement<T>(void* destination, int index, T value) =>
            SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(destination), index) = value;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static T ReadArrayElementWithStride<T>(void* source, int index, int stride) =>
            SystemUnsafe.ReadUnaligned<T>((byte*)source + (long)index * stride);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void WriteArrayElementWithStride<T>(void* destination, int index, int stride, T value) =>
            SystemUnsafe.WriteUnaligned((byte*)destination + (long)index * stride, value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void* AddressOf<T>(ref T output) where T : struct => SystemUnsafe.AsPointer(ref output);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ref T As<U, T>(ref U from) => ref SystemUnsafe.As<U, T>(ref from);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ref T AsRef<T>(void* ptr) where T : struct => ref SystemUnsafe.AsRef<T>(ptr);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ref T ArrayElementAsRef<T>(void* ptr, int index) where T : struct =>
            ref SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(ptr), index);

        public static void CopyPtrToStructure<T>(void* ptr, out T output) where T : struct =>
            output = SystemUnsafe.ReadUnaligned<T>(ptr);

        public static void CopyStructureToPtr<T>(ref T input, void* ptr) where T : struct =>
            SystemUnsafe.WriteUnaligned(ptr, input);

        public static bool IsUnmanaged<T>() => !RuntimeHelpers.IsReferenceOrContainsReferences<T>();

        public static bool IsBlittable<T>() where T : struct => IsUnmanaged<T>();

        public static int EnumToInt<T>(T enumValue) where T : struct, IConvertible => enumValue.ToInt32(null);

        public static bool EnumEquals<T>(T lhs, T rhs) where T : struct, IConvertible => lhs.Equals(rhs);

        static void CheckAllocator(Allocator allocator)
        {
            if (allocator != Allocator.Persistent && allocator != Allocator.TempJob && allocator != Allocator.Domain
                && allocator != Allocator.AudioKernel)
                throw new ArgumentException($"Invalid allocator: {allocator}.", nameof(allocator));
        }

#pragma warning disable CS0649 // Only measured, never filled.
        struct AlignOfHelper<T> where T : struct
        {
            public byte Dummy;
            public T Data;
        }
#pragma warning restore CS0649
    }
}
