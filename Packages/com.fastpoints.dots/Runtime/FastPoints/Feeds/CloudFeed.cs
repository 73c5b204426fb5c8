using System;
using FastPoints.Base;
using FastPoints.Picture;
using FastPoints.Points;
using FastPoints.Streaming;

namespace FastPoints.Feeds
{
    /// <summary>
    /// The states of one cloud, each better than the one before, from a first preview to the whole: told of as they come, and
    /// made a <see cref="NodeSource"/> when they are taken. Made on any thread; everything else on the main thread, and nothing
    /// waits but <see cref="Dispose"/>.
    /// </summary>
    public abstract class CloudFeed : IDisposable
    {
        /// <summary>The newest state that nobody has taken; null for none.</summary>
        public abstract CloudFacts Newest { get; }

        /// <summary>Whether nothing newer is expected.</summary>
        public abstract bool IsEnded { get; }

        /// <summary>Whether what was taken of a build in progress is not to be shown any more: it was broken off.</summary>
        public virtual bool IsBuildGone => false;

        /// <summary>Makes a source of <see cref="Newest"/>; the caller's from now on.</summary>
        /// <param name="planes">Names of planes that are streamed beside the position; those that the cloud has not are left
        /// out.</param>
        /// <exception cref="PointCloudException">It cannot be streamed.</exception>
        public abstract NodeSource Take(params string[] planes);

        /// <summary>Once a frame: goes on for about so long.</summary>
        /// <exception cref="PointCloudException">The cloud cannot be read; what was taken stays as it is.</exception>
        public abstract void Update(double budgetMs);

        /// <summary>Somebody else makes better states: what takes a look through all of the source is left to him.</summary>
        public virtual void Hurry()
        {
        }

        /// <summary>What is finished may be another now.</summary>
        public virtual void Refresh()
        {
        }

        public abstract void Dispose();
    }

    /// <summary>What a state of a cloud says of itself before it is streamed: enough to place and to colour it.</summary>
    public sealed class CloudFacts
    {
        public CloudStage Stage;

        /// <summary>Georeferenced, CRS units: what its source claims where that claims something.</summary>
        public BoundsGeo BoundsGeo;

        /// <summary>Metres of a horizontal unit; 0 where unknown, NaN where it is an angle.</summary>
        public double MetresPerUnit;

        public DisplayRanges Ranges;

        /// <summary>Whether the ranges are those of all values, strays included: of a manifest that knows no better, not of a
        /// sample.</summary>
        public bool RangesHaveStrays;
    }
}
