using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Store;

namespace FastPoints.Build
{
    /// <summary>The result of a conversion.</summary>
    public sealed class ConvertResult
    {
        public CloudManifest Manifest;
        public int LevelCount;
        public long BytesOnDisk;

        /// <summary>The largest size of temporary files; 0 if all points were in memory.</summary>
        public long TemporaryBytesPeak;

        /// <summary>The number of points that chunks were planned for; the stored bytes depend on it.</summary>
        public long PointsPerChunk;

        /// <summary>How long single runs of the octree's own jobs took: median, 99th percentile, longest; in steps of 0.1
        /// ms.</summary>
        public double[] SliceMs;

        /// <summary>A note about an earlier build of this target that was broken off, or null.</summary>
        public string Note;

        /// <summary>The planes' names and bytes, position first.</summary>
        public string[] PlaneNames;
        public long[] BytesOfPlane;

        /// <summary>Anomalies of the sources' points, besides what their readers report.</summary>
        public readonly List<CloudWarning> Warnings = new List<CloudWarning>();
    }

    /// <summary>The stages of a conversion in their order, as its progress names them.</summary>
    internal static class BuildStages
    {
        /// <summary>A sample of the source decides on the partition.</summary>
        public const string Sample = "sample";

        /// <summary>All points go to their chunks.</summary>
        public const string Read = "read";

        /// <summary>Chunks that are too large or too small are split or merged.</summary>
        public const string Split = "split";

        /// <summary>Chunks become nodes.</summary>
        public const string Index = "index";

        /// <summary>The levels above the chunks are made.</summary>
        public const string Merge = "merge";

        public const string Finish = "finish";
    }
}
