using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>Where a cloud is in a player: below its streaming assets.</summary>
    internal static class PlayerPath
    {
        /// <summary>As in the project, where the cloud is in the place of converted clouds; else by its name and its
        /// asset.</summary>
        /// <param name="cloudPath">As a handle says it.</param>
        /// <param name="asset">The asset's number: no two clouds of one name meet.</param>
        public static string Of(string cloudPath, string asset)
        {
            const string place = ProjectPaths.DefaultClouds + "/";
            if (cloudPath.StartsWith(PointCloudFile.InPlace, StringComparison.Ordinal))
                return place + cloudPath.Substring(PointCloudFile.InPlace.Length);
            if (cloudPath.StartsWith(place, StringComparison.Ordinal) && cloudPath.IndexOf('/', place.Length) < 0)
                return cloudPath;
            string name = AssetNaming.Safe(Path.GetFileNameWithoutExtension(cloudPath.TrimEnd('/', '\\')));
            return place + name + "-" + Short(asset) + StoreFormat.FolderExtension;
        }

        /// <summary>Of a file or folder that is streamed as it is.</summary>
        /// <param name="source">As a handle says it.</param>
        /// <param name="asset">The asset's number.</param>
        public static string OfSource(string source, string asset) => ProjectPaths.DefaultClouds + "/" + Short(asset) + "/" +
            AssetNaming.Safe(Path.GetFileName(source.TrimEnd('/', '\\')));

        static string Short(string asset) => asset.Substring(0, Math.Min(8, asset.Length));
    }
}
