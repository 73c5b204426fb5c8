using System;
using FastPoints.Nodes;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Some upper nodes that were made in one go: those above a few chunks, or above other regions. The top node of a
    /// region, like a chunk's, belongs to the region above; the root's has none above. Owns its table.</summary>
    internal sealed class UpperRegion : IDisposable
    {
        /// <summary>Records and planes of the nodes, as the writer made them.</summary>
        public NativeArray<byte> Table;

        /// <summary>For each draft, its node in the table, or -1 for the top that belongs to the region above.</summary>
        public int[] NodeOfDraft;
        public int NodeCount;

        /// <summary>Added to the planes' offsets.</summary>
        public long PlaneShift;

        /// <summary>The region above, and the draft there that this region's parentless nodes are attached to. Null for the
        /// root.</summary>
        public UpperRegion Above;
        public int AttachDraft;

        /// <summary>Number of the region's first node when all regions' tables are put one after the other.</summary>
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
        public FastPoints.Core.GridCube Cube;
        public ChunkTop Top;
        public int TopPoints;

        /// <summary>The chunk whose top it is, or -1.</summary>
        public int Chunk = -1;

        /// <summary>The region whose top it is, or null.</summary>
        public UpperRegion Region;

        /// <summary>The top's records, if they are in memory.</summary>
        public NativeArray<byte> Records;
    }
}
