using FastPoints.Samplers;

namespace FastPoints.Convert
{
    /// <summary>How a cloud is converted.</summary>
    public sealed class ConvertSettings
    {
        /// <summary>Names of the attributes that are kept; null for all. The position is always kept.</summary>
        public string[] Attributes;

        public Sampler Sampler;

        /// <summary>log2 of the sampling cells along a node's edge, 4 to 8: the spacing is the node's edge by that; 0 for the
        /// default
        /// of <see cref="NodeSizes"/>.</summary>
        public int CellsLog2;

        /// <summary>A cube with no more points left is a leaf; 0 for the default of <see cref="NodeSizes"/>.</summary>
        public int MaxPointsPerLeaf;

        /// <summary>Chunks have at most about so many points, and are no smaller than they need be; 0 for a number that suits the
        /// cloud. The stored bytes depend on it, and on nothing about the machine.</summary>
        public long PointsPerChunk;

        /// <summary>For all that grows with the number of points: records, blocks being read, chunks in work. Points that do not
        /// fit go to temporary files in the target's folder. Where it is little the chunks are smaller, by halves, and so other
        /// bytes are stored.</summary>
        public long MemoryBytes = 928L << 20;

        /// <summary>A build that goes to files can be taken up after each so many points.</summary>
        public long PointsPerCheckpoint = 8000000;

        /// <summary>While chunks become nodes, what is finished is made a cloud that can be opened, at most so often.</summary>
        public double SecondsPerGeneration = 5;

        /// <summary>Where reading the sources takes longer, a sample of them is made a cloud that can be opened.</summary>
        public double SecondsToFirstGeneration = 1;

        /// <summary>Workers of the job system that this work keeps busy at most: so many blocks are read and decoded, and so many
        /// chunks are sorted, at once. 0 for all. The stored bytes are the same.</summary>
        public int Workers;

        /// <summary>Whether what lies on disk stays there when the work is disposed before its end: the next build of the target
        /// with the same sources and settings continues it, where points were in files. May be set while the work goes
        /// on.</summary>
        public bool KeepUnfinished;
    }
}
