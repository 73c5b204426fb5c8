using System.Collections.Generic;
using FastPoints.Gpu;
using FastPoints.Streaming;

namespace FastPoints.Picking
{
    /// <summary>What a ray may hit of a cloud, and what a search may take.</summary>
    public sealed class PickOptions
    {
        /// <summary>What the cloud is clipped by: what is not shown is not hit.</summary>
        public List<ClipBox> ClipBoxes = new List<ClipBox>();

        /// <summary>Classes whose points are not shown. Nothing where the cloud has no classes.</summary>
        public ClassMask HiddenClasses;

        /// <summary>Of a node whose points lie nearer to each other than this share of the ray's radius, nothing below is
        /// looked at:
        /// a screen shows no more. 0 looks at every point.</summary>
        public double FinestSpacing = 0.1;

        /// <summary>A search that has read so much ends with what it has found.</summary>
        public long MostBytes = 256 << 20;
    }
}
