using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Store;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The converted clouds of a project: every <c>.fastpoints</c> folder in their folder, found by path and by the id
    /// that follows from their content.</summary>
    internal sealed class CloudCatalog
    {
        struct CachedCloud
        {
            public long WrittenTicks;
            public CatalogCloud Cloud;
        }

        readonly ProjectPaths m_paths;
        readonly List<CatalogCloud> m_clouds = new List<CatalogCloud>();
        Dictionary<string, CachedCloud> m_cached = new Dictionary<string, CachedCloud>();

        public CloudCatalog(ProjectPaths paths) => m_paths = paths;

        public IReadOnlyList<CatalogCloud> Clouds => m_clouds;

        public void Refresh()
        {
            m_clouds.Clear();
            var cached = new Dictionary<string, CachedCloud>();
            foreach (string folder in FolderPaths(m_paths.Clouds))
            {
                bool isPart = folder.EndsWith(StoreFormat.UnfinishedSuffix, StringComparison.Ordinal);
                string path = StoreFormat.FinishedPath(folder);
                // While a cloud is rebuilt, the old one still exists.
                if (path.EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase) &&
                    !(isPart && Directory.Exists(path)))
                    m_clouds.Add(ReadFolder(path, folder, cached));
            }
            m_cached = cached;
            m_clouds.Sort((a, b) => string.CompareOrdinal(a.Path, b.Path));
        }

        /// <summary>Finds the cloud of a handle: where the handle says, or else by id among those that <see cref="Refresh"/>
        /// found.</summary>
        public CatalogMatch Find(CloudHandle handle, out CatalogCloud cloud)
        {
            string path = m_paths.Absolute(handle.CloudPath);
            cloud = m_clouds.Find(c => string.Equals(c.Path, path, StringComparison.OrdinalIgnoreCase));
            if (cloud == null && CloudFolder.IsCloud(path))
                cloud = ReadFolder(path, CloudFolder.FinalOrUnfinished(path), new Dictionary<string, CachedCloud>());
            if (cloud != null && cloud.IsUnfinished)
                return CatalogMatch.Unfinished;
            if (cloud?.Manifest != null && (handle.CloudId == 0 || cloud.Manifest.CloudId == handle.CloudId))
                return CatalogMatch.InPlace;
            var inPlace = cloud;
            if (handle.CloudId != 0)
                cloud = m_clouds.Find(c => !c.IsUnfinished && c.Manifest != null && c.Manifest.CloudId == handle.CloudId);
            if (handle.CloudId != 0 && cloud != null)
                return CatalogMatch.Moved;
            cloud = inPlace;
            return inPlace == null ? CatalogMatch.None : CatalogMatch.Another;
        }

        /// <summary>Names for new clouds: none that a cloud or a build has already.</summary>
        /// <param name="reserved">Folders that belong to other clouds, even if they do not exist yet.</param>
        public FreePaths NewTargets(IEnumerable<string> reserved)
        {
            var taken = new List<string>(reserved);
            foreach (string folder in FolderPaths(m_paths.Clouds))
                taken.Add(StoreFormat.FinishedPath(folder));
            return new FreePaths(m_paths.Clouds, StoreFormat.FolderExtension, taken);
        }

        /// <summary>Deletes a converted cloud: first its name, so that a half-deleted one never passes for a complete
        /// one. It may keep that while its files are open; the rest is done on a pool thread.</summary>
        public static void Delete(string path)
        {
            CloudFolderWriter.DeleteUnfinished(path);
            if (!Directory.Exists(path))
                return;
            FolderReleases.Release(path);
            FileChanges.BeginDelete(path, failure =>
            {
                FolderReleases.Reacquire(path);
                if (failure != null)
                    Debug.LogError("FastPoints: " + FileFailures.WriteFailure(path, failure).Message);
            });
            FileChanges.TryDelete(StampFile.PathOf(path), () => false);
            FileChanges.TryDelete(CloudThumbnails.PathOf(path), () => false);
        }

        CatalogCloud ReadFolder(string path, string folder, Dictionary<string, CachedCloud> cached)
        {
            string manifest = Path.Combine(folder, StoreFormat.ManifestName);
            long written = File.GetLastWriteTimeUtc(manifest).Ticks;
            if (m_cached.TryGetValue(folder, out var before) && before.WrittenTicks == written)
            {
                cached[folder] = before;
                return before.Cloud;
            }
            bool isPart = folder.EndsWith(StoreFormat.UnfinishedSuffix, StringComparison.Ordinal);
            var cloud = new CatalogCloud { Path = path, IsUnfinished = isPart };
            try
            {
                cloud.Manifest = CloudManifest.FromJson(StoreFile.ReadText(manifest), manifest);
            }
            catch (PointCloudException e)
            {
                cloud.Problem = e.Message;
            }
            cached[folder] = new CachedCloud { WrittenTicks = written, Cloud = cloud };
            return cloud;
        }

        static string[] FolderPaths(string folder)
        {
            try
            {
                return Directory.Exists(folder) ? Directory.GetDirectories(folder) : Array.Empty<string>();
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.ReadFailure(folder, e);
            }
        }
    }

    internal sealed class CatalogCloud
    {
        public string Path; // Its folder: an absolute path under its final name.
        public CloudManifest Manifest; // Null if Problem says why.
        public string Problem; // Why it cannot be used, in one line; null if it can.
        public bool IsUnfinished;

        public string Name => System.IO.Path.GetFileNameWithoutExtension(Path);
    }

    internal enum CatalogMatch
    {
        None,
        InPlace,
        Moved, // It is in another folder of the project's clouds, found by its id.
        Another, // Another cloud is at the handle's path, and its own was not found.
        Unfinished,
    }
}
