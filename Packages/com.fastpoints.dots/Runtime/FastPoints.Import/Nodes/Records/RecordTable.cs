using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    internal unsafe struct RecordTable
    {
        [NativeDisableUnsafePtrRestriction] public byte* Records;
        public RecordLayout Layout;
        public Grid3 Corner; // Corner of the chunk: positions are ordered relative to it.

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public byte* At(uint number) => Records + (long)number * Layout.StrideBytes;

        /// <summary>Compares records independently of their order of arrival: along the Morton curve, and at equal positions by
        /// their attributes' bytes. 0 for equal records.</summary>
        int Compare(uint a, uint b)
        {
            byte* first = At(a), second = At(b);
            int order = MortonOrder.Compare(Layout.PositionOf(first) - Corner, Layout.PositionOf(second) - Corner);
            if (order != 0)
                return order;
            var x = (uint*)Layout.AttributesOf(first);
            var y = (uint*)Layout.AttributesOf(second);
            for (int i = 0; i < Layout.AttributeBytes >> 2; i++)
                if (x[i] != y[i])
                    return x[i] < y[i] ? -1 : 1;
            return 0;
        }

        /// <summary>Sorts a run of keys in place.</summary>
        /// <param name="mask">The bits of a key that are the record's number.</param>
        public void Sort(ulong* keys, int count, ulong mask)
        {
            if (IsSorted(keys, count, mask))
                return;
            if (count <= 24)
                InsertionSort(keys, count, mask);
            else
                HeapSort(keys, count, mask);
        }

        int Compare(ulong a, ulong b, ulong mask) => Compare((uint)(a & mask), (uint)(b & mask));

        /// <summary>Whether keys are sorted already, which is worth checking for millions of equal points.</summary>
        bool IsSorted(ulong* keys, int count, ulong mask)
        {
            for (int i = 1; i < count; i++)
                if (Compare(keys[i - 1], keys[i], mask) > 0)
                    return false;
            return true;
        }

        void InsertionSort(ulong* keys, int count, ulong mask)
        {
            for (int i = 1; i < count; i++)
            {
                ulong moved = keys[i];
                int at = i;
                for (; at > 0 && Compare(keys[at - 1], moved, mask) > 0; at--)
                    keys[at] = keys[at - 1];
                keys[at] = moved;
            }
        }

        void HeapSort(ulong* keys, int count, ulong mask)
        {
            for (int root = count / 2 - 1; root >= 0; root--)
                SiftDown(keys, root, count, mask);
            for (int end = count - 1; end > 0; end--)
            {
                (keys[0], keys[end]) = (keys[end], keys[0]);
                SiftDown(keys, 0, end, mask);
            }
        }

        void SiftDown(ulong* keys, int root, int count, ulong mask)
        {
            ulong moved = keys[root];
            for (int child; (child = 2 * root + 1) < count; root = child)
            {
                if (child + 1 < count && Compare(keys[child], keys[child + 1], mask) < 0)
                    child++;
                if (Compare(moved, keys[child], mask) >= 0)
                    break;
                keys[root] = keys[child];
            }
            keys[root] = moved;
        }
    }

    /// <summary>Compares positions of any size along the Morton curve without computing codes. Coordinates must not be
    /// negative.</summary>
    internal static class MortonOrder
    {
        /// <summary>Negative if a comes first, 0 for equal positions.</summary>
        public static int Compare(Grid3 a, Grid3 b)
        {
            ulong x = (ulong)(a.X ^ b.X), y = (ulong)(a.Y ^ b.Y), z = (ulong)(a.Z ^ b.Z);
            // The axis with the highest differing bit decides; at equal levels z counts more than y, and y more than x.
            if (IsHigher(x, y))
                return IsHigher(x, z) ? Compare(a.X, b.X) : Compare(a.Z, b.Z);
            return IsHigher(y, z) ? Compare(a.Y, b.Y) : Compare(a.Z, b.Z);
        }

        static int Compare(long a, long b) => a < b ? -1 : a > b ? 1 : 0;

        /// <summary>log2 of the side of the smallest cube of the octree with both positions.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int CommonCubeLog2(Grid3 a, Grid3 b) => 64 - math.lzcnt((ulong)(a.X ^ b.X | a.Y ^ b.Y | a.Z ^ b.Z));

        static bool IsHigher(ulong a, ulong b) => a > b && (a ^ b) > b;
    }
}
