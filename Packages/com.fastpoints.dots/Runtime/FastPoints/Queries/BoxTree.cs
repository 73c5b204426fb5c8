using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // A tree over boxes in an order in which neighbours are near each other: eight of a level have one box in the next, up to
    // the one around all. Positions are in CRS units from the tree's corner, which is itself so from the root's.
    internal unsafe struct BoxTree
    {
        public const int FanOut = 8;
        const int FanOutLog2 = 3;

        // That many boxes are pending at most, since a level leaves all of a parent's but one.
        public const int MaxPending = (FanOut - 1) * (32 / FanOutLog2 + 1) + 1;

        [NativeDisableUnsafePtrRestriction] public LocalBox* Boxes; // The leaves, then level by level.
        public int LeafCount;
        public double3 Corner;

        // At all levels.
        public static int CountOf(int leaves)
        {
            int count = leaves;
            for (; leaves > 1; count += leaves)
                leaves = Above(leaves);
            return count;
        }

        public readonly LocalBox All => Boxes[CountOf(LeafCount) - 1]; // The box around all leaves, of which there are some.

        public readonly int TopLevel
        {
            get
            {
                int level = 0;
                for (int count = LeafCount; count > 1; count = Above(count))
                    level++;
                return level;
            }
        }

        public readonly LocalBox* LevelOf(int level, out int count)
        {
            var boxes = Boxes;
            count = LeafCount;
            for (; level > 0; level--)
            {
                boxes += count;
                count = Above(count);
            }
            return boxes;
        }

        public readonly void Build()
        {
            var below = Boxes;
            for (int count = LeafCount; count > 1; count = Above(count))
            {
                var above = below + count;
                for (int i = 0; i < count; i++)
                {
                    var parent = above + (i >> FanOutLog2);
                    *parent = (i & (FanOut - 1)) == 0 ? below[i] : LocalBox.Union(*parent, below[i]);
                }
                below = above;
            }
        }

        static int Above(int count) => (count + FanOut - 1) >> FanOutLog2;
    }

    internal struct LocalBox
    {
        const double Rounding = 1.2e-7; // Larger than what a float rounds away.

        public float3 Min;
        public float3 Max;

        public LocalBox(double3 min, double3 max) : this()
        {
            for (int axis = 0; axis < 3; axis++)
                SetAxis(axis, min[axis], max[axis]);
        }

        // Rounded outwards.
        public void SetAxis(int axis, double min, double max)
        {
            Min[axis] = (float)(min - math.abs(min) * Rounding);
            Max[axis] = (float)(max + math.abs(max) * Rounding);
        }

        public static LocalBox Union(in LocalBox a, in LocalBox b) =>
            new LocalBox { Min = math.min(a.Min, b.Min), Max = math.max(a.Max, b.Max) };
    }
}
