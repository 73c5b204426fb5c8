using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Drawing
{
    /// <summary>The states of one cloud, each better than the one before, from a first preview to the whole cloud; those that
    /// are taken become sources. Made on any thread; the rest is for the main thread, and only Dispose waits.</summary>
    public abstract class CloudFeed : IDisposable
    {
        /// <summary>The newest state that nobody has taken; null for none.</summary>
        public abstract CloudFacts Newest { get; }

        /// <summary>Whether nothing newer is expected.</summary>
        public abstract bool IsEnded { get; }

        // Nothing is in flight or waits to be taken: until a folder is polled again, updates change nothing.
        internal virtual bool IsIdle => IsEnded;

        /// <summary>Whether a build was aborted, so that the generations taken from it must no longer be shown.</summary>
        public virtual bool IsBuildAborted => false;

        /// <summary>Makes a source of Newest, which the caller owns, with the named planes besides the position, as far as the
        /// cloud has them. Throws a <see cref="PointCloudException"/> if the state cannot be streamed.</summary>
        public abstract NodeSource Take(params string[] planes);

        /// <summary>Works for about this long, once a frame. Throws if the cloud cannot be read; states taken stay
        /// valid.</summary>
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

        public CloudUnits Units;

        public DisplayRanges Ranges;

        /// <summary>Whether the ranges include outliers: those of a manifest without better ones.</summary>
        public bool RangesHaveOutliers;
        internal bool HasNormals; // Those of a converted cloud's points are stored.
    }

    /// <summary>Opens any cloud: converted ones here, others by a registered reader (FastPoints.Import, if it is
    /// loaded), so that a player that only shows converted clouds carries no readers.</summary>
    public static class CloudFeeds
    {
        static readonly string[] s_none = new string[0];
        static Func<IReadOnlyList<string>, CloudFeed> s_openSource;

        /// <summary>Registers what opens other files than converted clouds, on any thread. The last one wins.</summary>
        public static void Register(Func<IReadOnlyList<string>, CloudFeed> openSource) => s_openSource = openSource;

        /// <summary>Opens a cloud and reads headers on the calling thread. The converted folder may not exist yet if the files
        /// do that it is made of: they are shown until then. Without those the path may be any point cloud. Throws if neither
        /// exists, or what exists is damaged.</summary>
        public static CloudFeed Open(string path, IReadOnlyList<string> sources = null)
        {
            sources ??= s_none;
            if (!CloudFolder.IsCloud(path))
            {
                if (sources.Count > 0)
                    return new FileFeed(path, sources, OpenSource(sources), new FolderFeed(new GenerationPoller(path)),
                        OpenSource);
                if (SourcePath.IsRemote(path) ||
                    !path.EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase) &&
                    (File.Exists(path) || Directory.Exists(path)))
                    return OpenSource(new[] { path });
            }
            var folder = CloudFolder.Open(path);
            var converted = new FolderFeed(new GenerationPoller(folder));
            return new FileFeed(path, sources, folder.IsUnfinished ? TryOpenSource(sources) : null, converted, OpenSource);
        }

        /// <summary>Opens files that are no converted cloud. Throws if no registered reader can.</summary>
        public static CloudFeed OpenSource(IReadOnlyList<string> paths) => s_openSource != null ? s_openSource(paths)
            : throw new PointCloudException(FailureCode.Unsupported, paths[0], -1,
                "is no converted cloud, and no readers for other files are there: wanted a " + StoreFormat.FolderExtension +
                " folder, or the assembly FastPoints.Import in the player");

        // Null if they cannot be opened: a build in progress can be shown without them.
        static CloudFeed TryOpenSource(IReadOnlyList<string> paths)
        {
            if (paths.Count == 0 || s_openSource == null)
                return null;
            try
            {
                return OpenSource(paths);
            }
            catch (PointCloudException)
            {
                return null;
            }
        }
    }
}
