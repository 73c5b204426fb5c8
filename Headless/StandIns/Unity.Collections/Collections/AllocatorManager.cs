using System;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Collections
{
    public static unsafe class AllocatorManager
    {
        public const int kErrorNone = 0;
        public const int kErrorBufferOverflow = -1;
        public const ushort FirstUserIndex = 64;

        public static readonly AllocatorHandle Invalid = new AllocatorHandle { Index = 0 };
        public static readonly AllocatorHandle None = new AllocatorHandle { Index = 1 };
        public static readonly AllocatorHandle Temp = new AllocatorHandle { Index = 2 };
        public static readonly AllocatorHandle TempJob = new AllocatorHandle { Index = 3 };
        public static readonly AllocatorHandle Persistent = new AllocatorHandle { Index = 4 };

        /// <summary>Unity's own allocators by number; allocators of one's own are not here.</summary>
        public struct AllocatorHandle : IEquatable<AllocatorHandle>, IComparable<AllocatorHandle>
        {
            public ushort Index;
            public ushort Version;

            public int Value => Index;

            public Allocator ToAllocator => (Allocator)Index;

            public bool IsCustomAllocator => Index >= FirstUserIndex;

            public static implicit operator AllocatorHandle(Allocator a) => new AllocatorHandle { Index = (ushort)a };

            public bool Equals(AllocatorHandle other) => Index == other.Index && Version == other.Version;

            public bool Equals(Allocator other) => ToAllocator == other;

            public override bool Equals(object obj) => obj is AllocatorHandle other && Equals(other);

            public override int GetHashCode() => (Version << 16) | Index;

            public int CompareTo(AllocatorHandle other) => Index - other.Index;

            public static bool operator ==(AllocatorHandle lhs, AllocatorHandle rhs) => lhs.Equals(rhs);

            public static bool operator !=(AllocatorHandle lhs, AllocatorHandle rhs) => !lhs.Equals(rhs);

            public static bool operator <(AllocatorHandle lhs, AllocatorHandle rhs) => lhs.Index < rhs.Index;

            public static bool operator >(AllocatorHandle lhs, AllocatorHandle rhs) => lhs.Index > rhs.Index;

            public static bool operator <=(AllocatorHandle lhs, AllocatorHandle rhs) => lhs.Index <= rhs.Index;

            public static bool operator >=(AllocatorHandle lhs, AllocatorHandle rhs) => lhs.Index >= rhs.Index;
        }

        public static AllocatorHandle ConvertToAllocatorHandle(Allocator a) => a;

        public static void* Allocate(AllocatorHandle handle, int itemSizeInBytes, int alignmentInBytes, int items = 1)
        {
            CheckHandle(handle);
            return UnsafeUtility.MallocTracked((long)itemSizeInBytes * items, alignmentInBytes, handle.ToAllocator, 0);
        }

        public static T* Allocate<T>(AllocatorHandle handle, int items = 1) where T : unmanaged =>
            (T*)Allocate(handle, sizeof(T), UnsafeUtility.AlignOf<T>(), items);

        public static void Free(AllocatorHandle handle, void* pointer)
        {
            CheckHandle(handle);
            UnsafeUtility.FreeTracked(pointer, handle.ToAllocator);
        }

        public static void Free(AllocatorHandle handle, void* pointer, int itemSizeInBytes, int alignmentInBytes,
            int items = 1) => Free(handle, pointer);

        public static void Free<T>(AllocatorHandle handle, T* pointer, int items = 1) where T : unmanaged =>
            Free(handle, (void*)pointer);

        static void CheckHandle(AllocatorHandle handle)
        {
            if (handle.Index <= (ushort)Allocator.None)
                throw new ArgumentException("Allocator must be Temp, TempJob, Persistent or a registered custom allocator");
            if (handle.IsCustomAllocator)
                throw new NotSupportedException("Custom allocators are not part of the headless stand-ins.");
        }
    }
}
