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

        public void Get(int box, out double3 middle, out double3 half)
        {
            middle = new double3(Middle[box], Middle[Count + box], Middle[2 * Count + box]);
            half = new double3(Half[box], Half[Count + box], Half[2 * Count + box]);
        }
    }
}
