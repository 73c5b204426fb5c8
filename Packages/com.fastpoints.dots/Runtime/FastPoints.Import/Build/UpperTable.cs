using System;
using System.Collections.Generic;
using FastPoints.Nodes;
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
        /// <param name="indexOfNode">Index in the table for each node number of <see cref="UpperRegion.NodeOf"/>.</param>
        /// <returns>Records and planes; the caller disposes it.</returns>
        public static NativeArray<byte> Join(IReadOnlyList<UpperRegion> regions, int planeCount, out int[] indexOfNode)
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
            indexOfNode = new int[count];
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
                    indexOfNode[child] = placed;
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
                    int node = region.FirstNode + i, place = indexOfNode[node];
                    var record = nodes[i];
                    record.Parent = parentOf[node] < 0 ? -1 : indexOfNode[parentOf[node]];
                    record.FirstChild = childCount[node] > 0 ? childrenAt[node] : 0;
                    record.ChildCount = childCount[node];
                    record.SampledWith = r;
                    record.PlaneNode = indexOfNode[region.FirstNode + record.PlaneNode];
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

    /// <summary>Upper nodes of one merge: those above a few chunks, or above other regions. The top node of a
    /// region, like a chunk's, belongs to the region above; the root's has none above. Owns its table.</summary>
    internal sealed class UpperRegion : IDisposable
    {
        /// <summary>Records and planes of the nodes, as the writer returned them.</summary>
        public NativeArray<byte> Table;

        /// <summary>For each draft, its node in the table, or -1 for the top that belongs to the region above.</summary>
        public int[] NodeOfDraft;
        public int NodeCount;

        public long PlaneShift;

        /// <summary>The region above, and the draft there that this region's parentless nodes are attached to. Null for the
        /// root.</summary>
        public UpperRegion Above;
        public int AttachDraft;

        /// <summary>Number of the region's first node when all regions' tables are concatenated.</summary>
        public int FirstNode;

        /// <summary>The number of the node that a draft became, possibly in a region above.</summary>
        public int NodeOf(int draft)
        {
            var region = this;
            while (region.NodeOfDraft[draft] < 0)
            {
                draft = region.AttachDraft;
                region = region.Above;
            }
            return region.FirstNode + region.NodeOfDraft[draft];
        }

        public void Dispose()
        {
            if (Table.IsCreated)
                Table.Dispose();
            Table = default;
        }
    }

    /// <summary>The merge's next input: a chunk's top, or a region's.</summary>
    internal sealed class UpperItem
    {
        public FastPoints.GridCube Cube;
        public ChunkTop Top;
        public int TopPoints;

        /// <summary>The chunk whose top it is, or -1.</summary>
        public int Chunk = -1;

        public UpperRegion Region;

        /// <summary>The top's records, if they are in memory.</summary>
        public NativeArray<byte> Records;
    }

    /// <summary>Assembles hierarchy.bin: the upper nodes' table and one record for each chunk.</summary>
    internal static unsafe class HierarchyFile
    {
        /// <summary>Makes the whole file; the caller disposes it. The manifest receives its size and hash.</summary>
        /// <param name="table">The upper nodes, then their planes' ranges in upper.bin.</param>
        /// <param name="chunks">The chunks, which are sorted here by the node they are attached to.</param>
        public static NativeArray<byte> Create(NativeArray<byte> table, int nodeCount, int planeCount, List<ChunkRecord> chunks,
            CloudManifest manifest)
        {
            chunks.Sort((a, b) => a.AttachNode != b.AttachNode ? a.AttachNode.CompareTo(b.AttachNode)
                : a.Number.CompareTo(b.Number));
            int chunkBytes = chunks.Count * ChunkRecord.SizeBytes;
            var file = new NativeArray<byte>(FileHeader.SizeBytes + table.Length + chunkBytes, Allocator.Persistent);
            var start = (byte*)file.GetUnsafePtr();
            byte* tableStart = start + FileHeader.SizeBytes;
            UnsafeUtility.MemCpy(tableStart, table.GetUnsafeReadOnlyPtr(), table.Length);
            var nodes = (NodeRecord*)tableStart;
            var records = (ChunkRecord*)(tableStart + table.Length);
            for (int i = 0; i < chunks.Count; i++)
            {
                records[i] = chunks[i];
                var node = nodes + chunks[i].AttachNode;
                if (node->ChunkCount++ == 0)
                    node->FirstChunk = i;
            }

            var header = new FileHeader
            {
                Magic = StoreFormat.HierarchyMagic,
                Version = StoreFormat.Version,
                PlaneCount = planeCount,
                NodeCount = nodeCount,
                ChunkCount = chunks.Count,
                PointCount = manifest.Points,
                TableOffset = FileHeader.SizeBytes,
                TableHash = ContentHash.Of(tableStart, table.Length + chunkBytes),
                FileBytes = file.Length,
                CloudId = manifest.CloudId,
            };
            header.HeaderHash = ContentHash.Of(&header, FileHeader.SizeBytes - sizeof(ulong));
            *(FileHeader*)start = header;
            manifest.HierarchyBytes = file.Length;
            manifest.HierarchyHash = ContentHash.Of(start, file.Length);
            return file;
        }
    }
}
