using System.Runtime.CompilerServices;
using FastPoints.Points;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Records
{
    /// <summary>A chunk's records by number: page * <see cref="RecordPages.RecordsPerPage"/> + place in the page.</summary>
    internal unsafe struct RecordTable
    {
        [NativeDisableUnsafePtrRestriction] public RecordPages.Page** Pages;
        public RecordLayout Layout;

        /// <summary>Corner of the chunk: positions are ordered relative to it.</summary>
        public Grid3 Corner;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public byte* At(uint number) =>
            RecordPages.RecordsOf(Pages[number >> RecordPages.RecordsPerPageLog2]) +
            (long)(number & (RecordPages.RecordsPerPage - 1)) * Layout.StrideBytes;

        /// <summary>Compares records independently of when they came: along the Morton curve, and at equal positions by their
        /// attributes' bytes. 0 for equal records.</summary>
        public int Compare(uint a, uint b)
        {
            byte* first = At(a), second = At(b);
            int order = MortonOrder.Compare(Layout.PlaceOf(first) - Corner, Layout.PlaceOf(second) - Corner);
            if (order != 0)
                return order;
            var x = (uint*)Layout.AttributesOf(first);
            var y = (uint*)Layout.AttributesOf(second);
            for (int i = 0; i < Layout.AttributeBytes >> 2; i++)
                if (x[i] != y[i])
                    return x[i] < y[i] ? -1 : 1;
            return 0;
        }

        /// <summary>Sorts a run of numbers in place.</summary>
        public void Sort(uint* numbers, int count)
        {
            if (IsSorted(numbers, count))
                return;
            if (count <= 24)
                InsertionSort(numbers, count);
            else
                HeapSort(numbers, count);
        }

        /// <summary>Whether numbers are sorted already, which is worth checking for millions of equal points.</summary>
        bool IsSorted(uint* numbers, int count)
        {
            for (int i = 1; i < count; i++)
                if (Compare(numbers[i - 1], numbers[i]) > 0)
                    return false;
            return true;
        }

        void InsertionSort(uint* numbers, int count)
        {
            for (int i = 1; i < count; i++)
            {
                uint moved = numbers[i];
                int at = i;
                for (; at > 0 && Compare(numbers[at - 1], moved) > 0; at--)
                    numbers[at] = numbers[at - 1];
                numbers[at] = moved;
            }
        }

        void HeapSort(uint* numbers, int count)
        {
            for (int root = count / 2 - 1; root >= 0; root--)
                SiftDown(numbers, root, count);
            for (int end = count - 1; end > 0; end--)
            {
                uint largest = numbers[0];
                numbers[0] = numbers[end];
                numbers[end] = largest;
                SiftDown(numbers, 0, end);
            }
        }

        void SiftDown(uint* numbers, int root, int count)
        {
            uint moved = numbers[root];
            for (int child; (child = 2 * root + 1) < count; root = child)
            {
                if (child + 1 < count && Compare(numbers[child], numbers[child + 1]) < 0)
                    child++;
                if (Compare(moved, numbers[child]) >= 0)
                    break;
                numbers[root] = numbers[child];
            }
            numbers[root] = moved;
        }
    }
}
