using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Feeds
{
    /// <summary>
    /// Opens whatever a path says. Converted clouds are known here; other files are left to whoever registers for them
    /// (FastPoints.Import, where it is loaded), so that a player that only shows converted clouds carries no readers.
    /// </summary>
    public static class CloudFeeds
    {
        static readonly string[] s_none = new string[0];
        static Func<IReadOnlyList<string>, CloudFeed> s_openSource;

        /// <summary>Whether other files than converted clouds can be opened.</summary>
        public static bool HasReaders => s_openSource != null;

        /// <summary>Takes charge of files that are no converted clouds. The last one who registers has it.</summary>
        /// <param name="openSource">Opens files and folders that make one cloud, on whatever thread; throws a
        /// <see cref="PointCloudException"/>. Null for nobody.</param>
        public static void Register(Func<IReadOnlyList<string>, CloudFeed> openSource) => s_openSource = openSource;

        /// <summary>Opens a cloud; reads headers, on the calling thread.</summary>
        /// <param name="path">A converted folder, which may not be there yet where <paramref name="sources"/> are; without these,
        /// any other point cloud too.</param>
        /// <param name="sources">What the folder is made of: shown until it is there. Null or none where nobody knows.</param>
        /// <exception cref="PointCloudException">Neither is there, or what is there is damaged.</exception>
        public static CloudFeed Open(string path, IReadOnlyList<string> sources = null)
        {
            sources ??= s_none;
            if (!CloudFolder.IsCloud(path))
            {
                if (sources.Count > 0)
                    return new FileFeed(path, sources, OpenSource(sources), new FolderFeed(new FolderGenerations(path)));
                if (!path.EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase) &&
                    (File.Exists(path) || Directory.Exists(path)))
                    return OpenSource(new[] { path });
            }
            var folder = CloudFolder.Open(path);
            var converted = new FolderFeed(new FolderGenerations(folder));
            return new FileFeed(path, sources, folder.IsInTheMaking ? TryOpenSource(sources) : null, converted);
        }

        /// <summary>Opens files that are no converted cloud.</summary>
        /// <exception cref="PointCloudException">They cannot be read, or nobody reads such files.</exception>
        public static CloudFeed OpenSource(IReadOnlyList<string> paths) => s_openSource != null ? s_openSource(paths)
            : throw new PointCloudException(FailureCode.Unsupported, paths[0], -1,
                "is no converted cloud, and no readers for other files are there: wanted a " + StoreFormat.FolderExtension +
                " folder, or the assembly FastPoints.Import in the player");

        /// <summary>What a build in progress shows does without.</summary>
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
