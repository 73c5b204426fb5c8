using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>All clouds of a project: of its assets, and converted ones without an asset. It is collected on a
    /// pool thread, since a thousand clouds have ten thousand files.</summary>
    internal sealed class CloudList
    {
        /// <summary>A cloud of an asset, or of none.</summary>
        public struct Row
        {
            public string Asset; // The asset's path; null for a cloud that is not used.

            public string Cloud; // The converted folder's absolute path; it may not exist.
            public string State;

            public long Points; // -1 if unknown.

            public long Bytes;

            public string MissingSource; // The first missing source; null if none is.
            public bool IsConverted;

            /// <summary>Whether it can be converted and is not, or an older one is, and does not wait for it; of several assets
            /// with one cloud, the first one's.</summary>
            public bool IsWanted;
            public bool IsLost;
        }

        public readonly List<Row> Rows = new List<Row>();

        /// <summary>Clouds of no asset and of no request, which may be deleted; none in a folder outside the project,
        /// for another project may use them.</summary>
        public readonly List<Row> Unused = new List<Row>();

        /// <summary>Clouds without data that can be converted, and those whose sources are missing too; none that waits for
        /// its conversion.</summary>
        public List<Row> Wanted { get; private set; }
        public List<Row> Lost { get; private set; }

        /// <summary>Collects the current clouds, on a pool thread.</summary>
        public static PoolTask<CloudList> Begin(EditorImports imports, bool measures = true,
            CancellationToken cancelled = default)
        {
            var (paths, reserved) = (imports.Paths, new List<string>(imports.Queue.ReservedPaths));
            var assets = new Dictionary<string, string>();
            foreach (var pair in imports.Assets.All)
                assets.Add(pair.Key, pair.Value);
            bool convertsOctrees = FastPointsSettings.instance.ConvertOctrees;
            return PoolTask.Begin(paths.Clouds, () => Collect(paths, assets, reserved, convertsOctrees, measures,
                cancelled));
        }

        /// <summary>Any thread.</summary>
        /// <param name="assets">Paths, each with the absolute path of its cloud.</param>
        /// <param name="reserved">Folders that are being made, or will be.</param>
        /// <param name="measures">Whether the sizes are wanted: they take a look at each file of each cloud.</param>
        public static CloudList Collect(ProjectPaths paths, IReadOnlyDictionary<string, string> assets,
            ICollection<string> reserved, bool convertsOctrees = false, bool measures = true,
            CancellationToken cancelled = default)
        {
            var list = new CloudList();
            var catalog = new CloudCatalog(paths);
            catalog.Refresh();
            var used = new HashSet<string>(reserved, StringComparer.OrdinalIgnoreCase);
            foreach (var pair in assets)
            {
                cancelled.ThrowIfCancellationRequested();
                bool isFirst = used.Add(pair.Value);
                var row = Describe(pair.Key, pair.Value, catalog, paths, convertsOctrees);
                row.Bytes = measures ? BytesOf(CloudFolder.FinalOrUnfinished(pair.Value), cancelled) : 0;
                row.IsWanted &= isFirst;
                row.IsLost = isFirst && row.MissingSource != null && !row.IsConverted;
                list.Rows.Add(row);
            }
            list.Rows.Sort((a, b) => string.CompareOrdinal(a.Asset, b.Asset));
            (list.Wanted, list.Lost) = (list.Rows.FindAll(r => r.IsWanted), list.Rows.FindAll(r => r.IsLost));
            if (paths.Clouds.StartsWith(paths.Project + Path.DirectorySeparatorChar, StringComparison.Ordinal))
                foreach (var cloud in catalog.Clouds)
                    if (!used.Contains(cloud.Path))
                    {
                        var row = Of(cloud);
                        row.Bytes = measures ? BytesOf(CloudFolder.FinalOrUnfinished(cloud.Path), cancelled) : 0;
                        list.Unused.Add(row);
                    }
            return list;
        }

        static Row Describe(string asset, string folder, CloudCatalog catalog, ProjectPaths paths, bool convertsOctrees)
        {
            var handle = new CloudHandle { CloudPath = paths.Stored(folder), Sources = { asset } };
            handle.IsSourceOctree = CloudSources.HasOctree(paths.Absolute(asset));
            var row = new Row { Asset = asset, Cloud = folder, Points = -1 };
            try
            {
                if (asset.EndsWith(CloudHandle.Extension, StringComparison.OrdinalIgnoreCase))
                    handle = HandleFile.Read(paths.Absolute(asset));
                var match = catalog.Find(handle, out var cloud);
                if (match == CatalogMatch.InPlace || match == CatalogMatch.Unfinished)
                    row = Of(cloud);
                else
                    row.State = handle.IsSourceOctree ? "streamed as it is" : match == CatalogMatch.Moved ? "converted data moved"
                        : match == CatalogMatch.Another ? "another cloud's data" : "not converted";
                row.MissingSource = CloudRelocation.FindMissingSource(handle, paths);
                // A changed source never converts to the cloud of the handle: the question would return for ever.
                row.IsWanted = row.MissingSource == null && handle.Sources.Count > 0 &&
                    (convertsOctrees || !handle.IsSourceOctree) && (match == CatalogMatch.None || match == CatalogMatch.Another &&
                    handle.Stamp?.Compare(handle.Sources.ConvertAll(paths.Absolute)) == SourceChange.None);
            }
            catch (PointCloudException e)
            {
                row.State = e.Message;
            }
            (row.Asset, row.Cloud) = (asset, folder);
            row.Points = row.Points < 0 ? handle.Points : row.Points;
            return row;
        }

        static Row Of(CatalogCloud cloud) => new Row
        {
            Cloud = cloud.Path,
            Points = cloud.Manifest?.Points ?? -1,
            State = cloud.Problem ?? (cloud.IsUnfinished ? "not finished" : "converted"),
            IsConverted = cloud.Manifest != null && !cloud.IsUnfinished,
        };

        static long BytesOf(string folder, CancellationToken cancelled)
        {
            long bytes = 0;
            cancelled.ThrowIfCancellationRequested();
            try
            {
                foreach (var file in new DirectoryInfo(folder).GetFiles("*", SearchOption.AllDirectories))
                    bytes += file.Length;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                // It is being made, or deleted.
            }
            return bytes;
        }
    }
}
