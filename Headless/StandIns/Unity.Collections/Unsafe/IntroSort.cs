using System.Collections.Generic;
using Unity.Collections;

namespace StandIns.Collections
{
    /// <summary>Quicksort that turns to heapsort when it goes too deep, and to insertion where little is left.</summary>
    static unsafe class IntroSort<T, TComparer> where T : unmanaged where TComparer : IComparer<T>
    {
        const int InsertionLength = 16;

        internal static void Sort(T* items, int length, TComparer comparer)
        {
            if (length > 1)
                Sort(items, length, 2 * CollectionHelper.Log2Floor(length), ref comparer);
        }

        static void Sort(T* items, int length, int depth, ref TComparer comparer)
        {
            while (length > InsertionLength)
            {
                if (depth-- == 0)
                {
                    HeapSort(items, length, ref comparer);
                    return;
                }
                int split = Partition(items, length, ref comparer);
                // The shorter side by recursion: the stack stays logarithmic whatever the depth says.
                if (split < length - split)
                {
                    Sort(items, split, depth, ref comparer);
                    items += split;
                    length -= split;
                }
                else
                {
                    Sort(items + split, length - split, depth, ref comparer);
                    length = split;
                }
            }
            for (int i = 1; i < length; i++)
            {
                T item = items[i];
                int at = i;
                for (; at > 0 && comparer.Compare(item, items[at - 1]) < 0; at--)
                    items[at] = items[at - 1];
                items[at] = item;
            }
        }

        // Hoare's: all before the split are <= all from it, and neither side is empty.
        static int Partition(T* items, int length, ref TComparer comparer)
        {
            T pivot = MedianOfThree(items[0], items[length / 2], items[length - 1], ref comparer);
            int low = 0;
            int high = length - 1;
            while (true)
            {
                while (low < length - 1 && comparer.Compare(items[low], pivot) < 0)
                    low++;
                while (high > 0 && comparer.Compare(items[high], pivot) > 0)
                    high--;
                if (low >= high)
                    break;
                Swap(items, low++, high--);
            }
            int split = low == high ? high + 1 : low;
            return split < 1 ? 1 : split > length - 1 ? length - 1 : split;
        }

        static T MedianOfThree(T a, T b, T c, ref TComparer comparer)
        {
            if (comparer.Compare(a, b) > 0)
                (a, b) = (b, a);
            return comparer.Compare(c, a) < 0 ? a : comparer.Compare(c, b) < 0 ? c : b;
        }

        static void HeapSort(T* items, int length, ref TComparer comparer)
        {
            for (int root = length / 2 - 1; root >= 0; root--)
                SiftDown(items, root, length, ref comparer);
            for (int last = length - 1; last > 0; last--)
            {
                Swap(items, 0, last);
                SiftDown(items, 0, last, ref comparer);
            }
        }

        static void SiftDown(T* items, int root, int length, ref TComparer comparer)
        {
            while (true)
            {
                int child = 2 * root + 1;
                if (child >= length)
                    return;
                if (child + 1 < length && comparer.Compare(items[child], items[child + 1]) < 0)
                    child++;
                if (comparer.Compare(items[root], items[child]) >= 0)
                    return;
                Swap(items, root, child);
                root = child;
            }
        }

        static void Swap(T* items, int a, int b) => (items[a], items[b]) = (items[b], items[a]);
    }
}
