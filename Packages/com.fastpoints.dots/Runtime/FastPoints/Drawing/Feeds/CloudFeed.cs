using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Core;
using FastPoints.Store;
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

    /// <summary>Opens any path that is a cloud. Converted clouds are handled here. Other files are left to a registered reader
    /// (FastPoints.Import, if it is loaded), so that a player that only shows converted clouds carries no readers.</summary>
    public static class CloudFeeds
    {
        static readonly string[] s_none = new string[0];
        static Func<IReadOnlyList<string>, CloudFeed> s_openSource;

        /// <summary>Registers what opens files that are not converted clouds. The last registration wins.</summary>
        /// <param name="openSource">Opens files and folders that make one cloud, on any thread; throws a <see
        /// cref="PointCloudException"/>. Null for none.</param>
        public static void Register(Func<IReadOnlyList<string>, CloudFeed> openSource) => s_openSource = openSource;

        /// <summary>Opens a cloud and reads headers on the calling thread.</summary>
        /// <param name="path">A converted folder, which may not exist yet if <paramref name="sources"/> do; without these, it
        /// may also be any other point cloud.</param>
        /// <param name="sources">The files that the folder is made of, which are shown until it exists. Null or empty if
        /// unknown.</param>
        /// <exception cref="PointCloudException">Neither exists, or what exists is damaged.</exception>
        public static CloudFeed Open(string path, IReadOnlyList<string> sources = null)
        {
            sources ??= s_none;
            if (!CloudFolder.IsCloud(path))
            {
                if (sources.Count > 0)
                    return new FileFeed(path, sources, OpenSource(sources), new FolderFeed(new FolderGenerations(path)),
                        OpenSource);
                if (!path.EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase) &&
                    (File.Exists(path) || Directory.Exists(path)))
                    return OpenSource(new[] { path });
            }
            var folder = CloudFolder.Open(path);
            var converted = new FolderFeed(new FolderGenerations(folder));
            return new FileFeed(path, sources, folder.IsUnfinished ? TryOpenSource(sources) : null, converted, OpenSource);
        }

        /// <summary>Opens files that are not a converted cloud.</summary>
        /// <exception cref="PointCloudException">They cannot be read, or no reader for such files is registered.</exception>
        public static CloudFeed OpenSource(IReadOnlyList<string> paths) => s_openSource != null ? s_openSource(paths)
            : throw new PointCloudException(FailureCode.Unsupported, paths[0], -1,
                "is no converted cloud, and no readers for other files are there: wanted a " + StoreFormat.FolderExtension +
                " folder, or the assembly FastPoints.Import in the player");

        // Null where they cannot be opened: a build in progress can be shown without them.
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
