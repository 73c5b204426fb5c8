using System;
using System.Collections.Generic;
using StandIns.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Collections
{
    /// <summary>Sorts in place, in O(n log n); equal elements may change places.</summary>
    public static unsafe class NativeSortExtension
    {
        public struct DefaultComparer<T> : IComparer<T> where T : IComparable<T>
        {
            public int Compare(T x, T y) => x.CompareTo(y);
        }

        public static void Sort<T>(T* ptr, int length) where T : unmanaged, IComparable<T> =>
            IntroSort<T, DefaultComparer<T>>.Sort(ptr, length, default);

        public static void Sort<T, U>(T* ptr, int length, U comp) where T : unmanaged where U : IComparer<T> =>
            IntroSort<T, U>.Sort(ptr, length, comp);

        public static void Sort<T>(this NativeArray<T> container) where T : unmanaged, IComparable<T> =>
            Sort((T*)container.GetUnsafePtr(), container.Length);

        public static void Sort<T, U>(this NativeArray<T> container, U comp) where T : unmanaged where U : IComparer<T> =>
            Sort((T*)container.GetUnsafePtr(), container.Length, comp);

        public static void Sort<T>(this NativeList<T> container) where T : unmanaged, IComparable<T> =>
            Sort(container.GetUnsafePtr(), container.Length);

        public static void Sort<T, U>(this NativeList<T> container, U comp) where T : unmanaged where U : IComparer<T> =>
            Sort(container.GetUnsafePtr(), container.Length, comp);

        public static void Sort<T>(this UnsafeList<T> container) where T : unmanaged, IComparable<T> =>
            Sort(container.Ptr, container.Length);

        public static void Sort<T, U>(this UnsafeList<T> container, U comp) where T : unmanaged where U : IComparer<T> =>
            Sort(container.Ptr, container.Length, comp);

        /// <returns>The index of an equal element, or the complement of where one would have to be.</returns>
        public static int BinarySearch<T>(T* ptr, int length, T value) where T : unmanaged, IComparable<T> =>
            BinarySearch(ptr, length, value, new DefaultComparer<T>());

        public static int BinarySearch<T, U>(T* ptr, int length, T value, U comp) where T : unmanaged where U : IComparer<T>
        {
            int from = 0;
            int to = length;
            while (from < to)
            {
                int middle = (int)(((uint)from + (uint)to) / 2);
                int order = comp.Compare(value, ptr[middle]);
                if (order == 0)
                    return middle;
                if (order < 0)
                    to = middle;
                else
                    from = middle + 1;
            }
            return ~from;
        }

        public static int BinarySearch<T>(this NativeArray<T> array, T value) where T : unmanaged, IComparable<T> =>
            BinarySearch((T*)array.GetUnsafeReadOnlyPtr(), array.Length, value);

        public static int BinarySearch<T, U>(this NativeArray<T> container, T value, U comp)
            where T : unmanaged where U : IComparer<T> =>
            BinarySearch((T*)container.GetUnsafeReadOnlyPtr(), container.Length, value, comp);

        public static int BinarySearch<T>(this NativeList<T> container, T value) where T : unmanaged, IComparable<T> =>
            BinarySearch(container.GetUnsafeReadOnlyPtr(), container.Length, value);

        public static int BinarySearch<T, U>(this NativeList<T> container, T value, U comp)
            where T : unmanaged where U : IComparer<T> =>
            BinarySearch(container.GetUnsafeReadOnlyPtr(), container.Length, value, comp);
    }
}
