using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // A tree over boxes in an order in which neighbours are near each other: eight of a level have one box in the next, up to
    // the one around all. Positions are in CRS units from the tree's corner, which is itself so from the root's.
    internal unsafe struct BoxTree
    {
        public const int FanOut = EightBoxes.Count;
        const int FanOutLog2 = 3;

        // That many boxes are pending at most, since a level leaves all of a parent's but one.
        public const int MaxPending = (FanOut - 1) * (32 / FanOutLog2 + 1) + 1;

        [NativeDisableUnsafePtrRestriction] public EightBoxes* Eights; // The leaves, then level by level.
        public int LeafCount;
        public double3 Corner;

        // At all levels.
        public static int EightsOf(int leaves)
        {
            int eights = Above(leaves);
            for (int count = leaves; count > 1; eights += Above(count))
                count = Above(count);
            return eights;
        }

        // The box around all leaves, of which there are some.
        public readonly void GetBounds(out double3 middle, out double3 half) =>
            Eights[EightsOf(LeafCount) - 1].Get(0, out middle, out half);

        public readonly int LevelBelowRoot
        {
            get
            {
                int level = 0;
                for (int count = LeafCount; count > FanOut; count = Above(count))
                    level++;
                return level;
            }
        }

        public readonly EightBoxes* BoxesOfLevel(int level, out int boxes)
        {
            var eights = Eights;
            boxes = LeafCount;
            for (; level > 0; level--)
            {
                boxes = Above(boxes);
                eights += boxes;
            }
            return eights;
        }

        public readonly void Build()
        {
            var below = Eights;
            for (int count = LeafCount; count > 1; count = Above(count))
            {
                var above = below + Above(count);
                for (int first = 0; first < count; first += FanOut)
                {
                    double3 min = double.PositiveInfinity, max = double.NegativeInfinity;
                    for (int i = 0; i < math.min(FanOut, count - first); i++)
                    {
                        below[first >> FanOutLog2].Get(i, out var middle, out var half);
                        min = math.min(min, middle - half);
                        max = math.max(max, middle + half);
                    }
                    above[first >> 2 * FanOutLog2].Set(first >> FanOutLog2 & (FanOut - 1), min, max);
                }
                below = above;
            }
        }

        // Before Build: so that boxes of all levels are small, leaves are halved along the longest side, again and again. Gives
        // where each was.
        public readonly void Order(uint* order)
        {
            long eights = Above(LeafCount) * (long)sizeof(EightBoxes);
            var from = (EightBoxes*)UnsafeUtility.Malloc(eights, 8, Allocator.Temp);
            uint* spare = (uint*)UnsafeUtility.Malloc(LeafCount * (long)sizeof(uint), 8, Allocator.Temp);
            ulong* keys = (ulong*)UnsafeUtility.Malloc(2L * LeafCount * sizeof(ulong), 8, Allocator.Temp);
            UnsafeUtility.MemCpy(from, Eights, eights);
            for (int i = 0; i < LeafCount; i++)
                order[i] = (uint)i;
            Halve(from, order, LeafCount, keys, spare);
            for (int i = 0; i < LeafCount; i++)
                for (int axis = 0; axis < 3 * FanOut; axis += FanOut)
                {
                    int to = axis + i % FanOut, at = axis + (int)order[i] % FanOut;
                    Eights[i / FanOut].Middle[to] = from[order[i] / FanOut].Middle[at];
                    Eights[i / FanOut].Half[to] = from[order[i] / FanOut].Half[at];
                }
            UnsafeUtility.Free(keys, Allocator.Temp);
            UnsafeUtility.Free(spare, Allocator.Temp);
            UnsafeUtility.Free(from, Allocator.Temp);
        }

        static void Halve(EightBoxes* boxes, uint* order, int count, ulong* keys, uint* spare)
        {
            if (count <= FanOut)
                return;
            float3 min = float.PositiveInfinity, max = float.NegativeInfinity;
            for (int i = 0; i < count; i++)
            {
                var middle = boxes[order[i] / FanOut].MiddleOf((int)order[i] % FanOut);
                min = math.min(min, middle);
                max = math.max(max, middle);
            }
            var size = max - min;
            int axis = size.x >= math.max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
            float scale = size[axis] > 0 ? ushort.MaxValue / size[axis] : 0;
            for (int i = 0; i < count; i++)
                keys[i] = (ulong)((boxes[order[i] / FanOut].MiddleOf((int)order[i] % FanOut)[axis] - min[axis]) * scale);
            RadixSort.Sort(keys, order, keys + count, spare, count);
            // The first half has whole boxes of the level below.
            int whole = FanOut;
            while (whole * FanOut < count)
                whole *= FanOut;
            int half = (count + whole - 1) / whole / 2 * whole;
            Halve(boxes, order, half, keys, spare);
            Halve(boxes, order + half, count - half, keys, spare);
        }

        static int Above(int count) => (count + FanOut - 1) >> FanOutLog2;
    }

    // Coordinate by coordinate, as processors compute with eight at once: those of x, then of y, then of z.
    internal unsafe struct EightBoxes
    {
        public const int Count = 8;
        const double Rounding = 1.2e-7; // Larger than what a float rounds away.

        public fixed float Middle[3 * Count];
        public fixed float Half[3 * Count];

        public void Set(int box, double3 min, double3 max)
        {
            for (int axis = 0; axis < 3; axis++)
                Set(box, axis, min[axis], max[axis]);
        }

        // Rounded outwards.
        public void Set(int box, int axis, double min, double max)
        {
            float middle = (float)((min + max) * 0.5);
            Middle[axis * Count + box] = middle;
            Half[axis * Count + box] = (float)(math.max(max - middle, middle - min) * (1 + Rounding));
        }

        public readonly float3 MiddleOf(int box) => new float3(Middle[box], Middle[Count + box], Middle[2 * Count + box]);

        public void Get(int box, out double3 middle, out double3 half)
        {
            middle = new double3(Middle[box], Middle[Count + box], Middle[2 * Count + box]);
            half = new double3(Half[box], Half[Count + box], Half[2 * Count + box]);
        }
    }
}
