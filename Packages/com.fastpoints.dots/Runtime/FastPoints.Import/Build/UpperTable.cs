using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>Joins the tables of the regions to the one table of the upper levels.</summary>
    internal static unsafe class UpperTable
    {
        /// <summary>Joins them in breadth-first order, a node's children one after the other.</summary>
        /// <param name="regions">The regions, each after the one above it, the root first. Their first nodes' numbers are set
        /// here.</param>
        /// <param name="planeCount">Number of planes of each node.</param>
        /// <param name="placeOfNode">Index in the table for each node number of <see cref="UpperRegion.NodeOf"/>.</param>
        /// <returns>Records and planes; the caller disposes it.</returns>
        public static NativeArray<byte> Join(IReadOnlyList<UpperRegion> regions, int planeCount, out int[] placeOfNode)
        {
            int count = 0;
            foreach (var region in regions)
            {
                region.FirstNode = count;
                count += region.NodeCount;
            }

            // These are chains of children, those of the first region first: inlined leaves stay in the order of their blocks.
            int[] parentOf = new int[count], firstChild = new int[count], next = new int[count];
            for (int i = 0; i < count; i++)
                firstChild[i] = -1;
            for (int r = regions.Count - 1; r >= 0; r--)
            {
                var region = regions[r];
                var nodes = (NodeRecord*)region.Table.GetUnsafeReadOnlyPtr();
                for (int i = region.NodeCount - 1; i >= 0; i--)
                {
                    int node = region.FirstNode + i;
                    int parent = nodes[i].Parent >= 0 ? region.FirstNode + nodes[i].Parent
                        : region.Above != null ? region.Above.NodeOf(region.AttachDraft) : -1;
                    parentOf[node] = parent;
                    if (parent < 0)
                        continue;
                    next[node] = firstChild[parent];
                    firstChild[parent] = node;
                }
            }

            var order = new int[count];
            placeOfNode = new int[count];
            var childrenAt = new int[count];
            var childCount = new int[count];
            int placed = count > 0 ? 1 : 0;
            for (int at = 0; at < placed; at++)
            {
                int node = order[at];
                for (int child = firstChild[node]; child >= 0; child = next[child])
                {
                    if (childCount[node]++ == 0)
                        childrenAt[node] = placed;
                    placeOfNode[child] = placed;
                    order[placed++] = child;
                }
            }

            var table = new NativeArray<byte>(count * (NodeRecord.SizeBytes + planeCount * PlaneRange.SizeBytes),
                Allocator.Persistent);
            var toNodes = (NodeRecord*)table.GetUnsafePtr();
            var toPlanes = (PlaneRange*)(toNodes + count);
            for (int r = 0; r < regions.Count; r++)
            {
                var region = regions[r];
                var nodes = (NodeRecord*)region.Table.GetUnsafeReadOnlyPtr();
                var planes = (PlaneRange*)(nodes + region.NodeCount);
                for (int i = 0; i < region.NodeCount; i++)
                {
                    int node = region.FirstNode + i, place = placeOfNode[node];
                    var record = nodes[i];
                    record.Parent = parentOf[node] < 0 ? -1 : placeOfNode[parentOf[node]];
                    record.FirstChild = childCount[node] > 0 ? childrenAt[node] : 0;
                    record.ChildCount = childCount[node];
                    record.SampledWith = r;
                    record.PlaneNode = placeOfNode[region.FirstNode + record.PlaneNode];
                    toNodes[place] = record;
                    for (int p = 0; p < planeCount; p++)
                    {
                        var range = planes[i * planeCount + p];
                        if (range.LengthBytes > 0)
                            range.OffsetBytes += region.PlaneShift;
                        toPlanes[place * planeCount + p] = range;
                    }
                }
            }
            return table;
        }
    }
}
