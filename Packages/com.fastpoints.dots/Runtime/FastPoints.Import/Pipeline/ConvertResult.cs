using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Store;

namespace FastPoints.Pipeline
{
    /// <summary>What a conversion has made.</summary>
    public sealed class ConvertResult
    {
        public CloudManifest Manifest;
        public int LevelCount;
        public long BytesOnDisk;

        /// <summary>The planes' names and bytes, position first.</summary>
        public string[] PlaneNames;
        public long[] BytesOfPlane;

        /// <summary>What was odd about the sources' points, beside what their readers say.</summary>
        public readonly List<CloudWarning> Warnings = new List<CloudWarning>();
    }
}
