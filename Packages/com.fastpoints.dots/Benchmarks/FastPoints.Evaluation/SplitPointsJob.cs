using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Measures the nodes of one level of a <see cref="PointTree"/>, and parts the points of each about the median
    /// of its longest edge; index i is the level's i-th node.</summary>
    [BurstCompile]
    public struct SplitPointsJob : IJobFor
    {
        public int Level;
        public bool IsLeaf;
        public int Count;

        /// <summary>Nodes of one level have disjoint places.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<double3> Points;
        [NativeDisableContainerSafetyRestriction] public NativeArray<PointTreeNode> Nodes;

        public unsafe void Execute(int index)
        {
            var points = (double3*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Points);
            int first = (int)PointTree.FirstOf(index, Level, Count), end = (int)PointTree.FirstOf(index + 1, Level, Count);
            var node = new PointTreeNode { Min = points[first], Max = points[first] };
            for (int i = first + 1; i < end; i++)
            {
                node.Min = math.min(node.Min, points[i]);
                node.Max = math.max(node.Max, points[i]);
            }
            ((PointTreeNode*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Nodes))[(1 << Level) + index] = node;
            if (IsLeaf)
                return;
            var size = node.Max - node.Min;
            int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            Select(points, axis, first, end - 1, (int)PointTree.FirstOf(2 * index + 1, Level + 1, Count));
        }

        /// <summary>Hoare's selection: what is less at <paramref name="axis"/> comes before the place, what is greater
        /// behind it. A pivot at a hashed place keeps any input linear on average; equal values part evenly.</summary>
        static unsafe void Select(double3* points, int axis, int first, int last, int place)
        {
            uint hash = (uint)(first * 747796405 + last);
            while (first < last)
            {
                hash = hash * 1664525 + 1013904223;
                double pivot = At(points, axis, first + (int)((hash >> 8) % (uint)(last - first + 1)));
                int low = first, high = last;
                while (low <= high)
                {
                    while (At(points, axis, low) < pivot)
                        low++;
                    while (At(points, axis, high) > pivot)
                        high--;
                    if (low > high)
                        break;
                    var swap = points[low];
                    points[low++] = points[high];
                    points[high--] = swap;
                }
                if (place <= high)
                    last = high;
                else if (place >= low)
                    first = low;
                else
                    return;
            }
        }

        static unsafe double At(double3* points, int axis, int place) => ((double*)(points + place))[axis];
    }
}
