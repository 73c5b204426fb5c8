using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Store;

namespace FastPoints.Build
{
    /// <summary>How a cloud is converted.</summary>
    public sealed class ConvertSettings
    {
        /// <summary>Names of the attributes to keep; null for all. The position is always kept.</summary>
        public string[] Attributes;

        public Sampler Sampler = Sampler.Poisson;

        /// <summary>log2 of the number of sampling cells along a node's edge, 4 to 8: the spacing is the node's edge divided by
        /// it; 0 for the default of <see cref="NodeSizes"/>.</summary>
        public int CellsLog2;

        /// <summary>A leaf has about this many points that no node above has taken; 0 for the default of
        /// <see cref="NodeSizes"/>.</summary>
        public int TargetPointsPerLeaf;

        /// <summary>Chunks have this many points at most, and are no smaller than needed; 0 for a number that suits the
        /// cloud. The stored bytes depend on it, but not on anything about the machine.</summary>
        public long PointsPerChunk;

        /// <summary>Limit for everything that grows with the number of points: records, blocks being read, chunks in progress.
        /// Points that do not fit go to temporary files in the target's folder. One chunk is always in progress, which may take
        /// more. The stored bytes are the same.</summary>
        public long MemoryBytes = 928L << 20;

        /// <summary>A build with temporary files has a checkpoint after this many points, or after fewer if reading is slow: as
        /// many as <see cref="SecondsPerCheckpoint"/> take at the pace until then.</summary>
        public long PointsPerCheckpoint = 8000000;

        public double SecondsPerCheckpoint = 30;

        /// <summary>Once sources have been read for longer than this, points that would fit into memory go to files as well, so
        /// that the build can be resumed. The stored bytes are the same.</summary>
        public double SecondsInMemory = double.PositiveInfinity;

        /// <summary>While chunks become nodes, finished ones are published as a cloud that can be opened, at most once in this
        /// time.</summary>
        public double SecondsPerGeneration = 5;

        /// <summary>If reading the sources takes longer than this, a sample of them is published as a cloud that can be
        /// opened.</summary>
        public double SecondsToFirstGeneration = 1;

        /// <summary>The most job workers that this keeps busy: this many blocks are read and decoded, and this
        /// many chunks are sorted, at the same time. 0 for all. May be set while the work is running, from the next piece on; the
        /// stored bytes are the same.</summary>
        public int Workers;

        /// <summary>For coroutines: the time between ticks, in ms, for which enough jobs are scheduled to keep workers
        /// busy, as memory allows. More where updates are rare, as in an editor without focus; ending the work early
        /// then takes as much longer. May be set while the work is running; the stored bytes are the same.</summary>
        public double InFlightMs = 50;

        /// <summary>Whether the files on disk stay there when the work is disposed early: the next build of the target with the
        /// same sources and settings continues from them, if points were in files. May be set while the work is
        /// running.</summary>
        public bool KeepUnfinished;

        /// <summary>Whether the grid has one step on all axes, so that the octree's cubes are cubes in the coordinates as
        /// well.</summary>
        internal bool HasUniformStep;

        /// <summary>See <see cref="MemoryPlan.PointsPerRegion"/>; 0 for what suits the cloud. The stored bytes depend on
        /// it.</summary>
        internal long PointsPerRegion;

        /// <summary>Memory of the process besides, if they are a limit together: less than a chunk takes is then an error. 0 for
        /// none.</summary>
        internal long ProcessBytes;
    }

    /// <summary>The result of a conversion.</summary>
    public sealed class ConvertResult
    {
        public CloudManifest Manifest;
        public int LevelCount;
        public long BytesOnDisk;

        /// <summary>The largest size of temporary files; 0 if all points were in memory.</summary>
        public long TemporaryBytesPeak;

        /// <summary>The most points of a chunk; the stored bytes depend on it.</summary>
        public long PointsPerChunk;

        /// <summary>How long the octree's jobs took: median, 99th percentile, longest; in steps of 0.1
        /// ms.</summary>
        public double[] SliceMs;

        /// <summary>A note about an earlier, interrupted build of this target, or null.</summary>
        public string Note;

        /// <summary>The planes' names and bytes, position first.</summary>
        public string[] PlaneNames;
        public long[] BytesOfPlane;

        /// <summary>Anomalies of the sources' points, besides what their readers report.</summary>
        public readonly List<CloudWarning> Warnings = new List<CloudWarning>();
    }

    internal static class BuildStages
    {
        public const string Sample = "sample";
        public const string Read = "read";
        public const string Split = "split";
        public const string Index = "index";
        public const string Merge = "merge";
        public const string Finish = "finish";
    }
}
