using System;
using FastPoints.Core;
using FastPoints.Streaming;

namespace FastPoints.Drawing
{
    /// <summary>The states of one cloud, each better than the one before, from a first preview to the whole cloud. A feed offers
    /// states as they come and makes a <see cref="NodeSource"/> of those that are taken. It can be made on any thread; everything
    /// else belongs to the main thread, and only <see cref="Dispose"/> waits.</summary>
    public abstract class CloudFeed : IDisposable
    {
        /// <summary>The newest state that nobody has taken; null for none.</summary>
        public abstract CloudFacts Newest { get; }

        /// <summary>Whether nothing newer is expected.</summary>
        public abstract bool IsEnded { get; }

        // Nothing is in flight and nothing waits to be taken: until it is time to look at a folder again, updates change
        // nothing.
        internal virtual bool IsIdle => IsEnded;

        /// <summary>Whether a build was broken off, so that the generations taken from it must no longer be shown.</summary>
        public virtual bool IsBuildAborted => false;

        /// <summary>Makes a source of <see cref="Newest"/>, which the caller owns from now on.</summary>
        /// <param name="planes">Names of planes that are streamed besides the position; those that the cloud lacks are left
        /// out.</param>
        /// <exception cref="PointCloudException">The state cannot be streamed.</exception>
        public abstract NodeSource Take(params string[] planes);

        /// <summary>Works for about this long; called once a frame.</summary>
        /// <exception cref="PointCloudException">The cloud cannot be read; states already taken stay valid.</exception>
        public abstract void Update(double budgetMs);

        /// <summary>Skips work that takes a pass over the whole source, because a build will offer better states.</summary>
        public virtual void SkipFullPass() { }

        /// <summary>Looks at a finished cloud again: it may have been replaced.</summary>
        public virtual void Refresh() { }

        public abstract void Dispose();
    }

    /// <summary>What is known of a cloud's state before it is streamed: enough to place and to colour it.</summary>
    public sealed class CloudFacts
    {
        public CloudStage Stage;

        /// <summary>Georeferenced, CRS units: the bounds that the source claims, if it claims any.</summary>
        public BoundsGeo BoundsGeo;

        /// <summary>Metres of a horizontal unit; 0 if unknown, NaN if the unit is an angle.</summary>
        public double MetresPerUnit;

        public DisplayRanges Ranges;

        /// <summary>Whether the ranges include all values, outliers too: those of a manifest without better ones, not of a
        /// sample.</summary>
        public bool RangesHaveOutliers;
    }
}
