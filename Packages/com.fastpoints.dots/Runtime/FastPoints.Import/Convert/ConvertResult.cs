using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Store;

namespace FastPoints.Convert
{
    /// <summary>What a conversion has made.</summary>
    public sealed class ConvertResult
    {
        public CloudManifest Manifest;
        public int LevelCount;
        public long BytesOnDisk;

        /// <summary>Most bytes that temporary files had; 0 where all points were in memory.</summary>
        public long TemporaryBytesPeak;

        /// <summary>What chunks were made for: the stored bytes depend on it.</summary>
        public long PointsPerChunk;

        /// <summary>How long single runs of the octree's own jobs took: median, 99th percentile, longest; in steps of 0.1
        /// ms.</summary>
        public double[] SliceMs;

        /// <summary>About a build of this target that was broken off before, or null.</summary>
        public string Note;

        /// <summary>The planes' names and bytes, position first.</summary>
        public string[] PlaneNames;
        public long[] BytesOfPlane;

        /// <summary>What was odd about the sources' points, beside what their readers say.</summary>
        public readonly List<CloudWarning> Warnings = new List<CloudWarning>();
    }

    /// <summary>What a conversion goes through, in this order, as its progress names it.</summary>
    internal static class BuildStages
    {
        /// <summary>Some points of the source decide on the partition.</summary>
        public const string Sample = "sample";

        /// <summary>All points go to their chunks.</summary>
        public const string Read = "read";

        /// <summary>Chunks that came out too large or too small.</summary>
        public const string Split = "split";

        /// <summary>Chunks become nodes.</summary>
        public const string Index = "index";

        /// <summary>The levels above the chunks.</summary>
        public const string Merge = "merge";

        public const string Finish = "finish";
    }
}
