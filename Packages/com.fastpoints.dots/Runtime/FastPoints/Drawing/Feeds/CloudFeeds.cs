using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Core;
using FastPoints.Store;

namespace FastPoints.Drawing
{
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
