using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>Decides where a cloud lies in a player, below its streaming assets.</summary>
    internal static class PlayerPath
    {
        /// <summary>The same path as in the project if the cloud is in the place of converted clouds; otherwise one made of its
        /// name and its asset.</summary>
        /// <param name="cloudPath">The path as a handle stores it.</param>
        /// <param name="asset">The asset's number, which keeps clouds with equal names apart.</param>
        public static string Of(string cloudPath, string asset)
        {
            const string place = ProjectPaths.DefaultClouds + "/";
            if (cloudPath.StartsWith(PointCloudPaths.InPlace, StringComparison.Ordinal))
                return place + cloudPath.Substring(PointCloudPaths.InPlace.Length);
            if (cloudPath.StartsWith(place, StringComparison.Ordinal) && cloudPath.IndexOf('/', place.Length) < 0)
                return cloudPath;
            string name = AssetNaming.Safe(Path.GetFileNameWithoutExtension(cloudPath.TrimEnd('/', '\\')));
            return place + name + "-" + Short(asset) + StoreFormat.FolderExtension;
        }

        /// <summary>The path of a file or folder that is streamed directly.</summary>
        /// <param name="source">The path as a handle stores it.</param>
        /// <param name="asset">The asset's number.</param>
        public static string OfSource(string source, string asset) => ProjectPaths.DefaultClouds + "/" + Short(asset) + "/" +
            AssetNaming.Safe(Path.GetFileName(source.TrimEnd('/', '\\')));

        static string Short(string asset) => asset.Substring(0, Math.Min(8, asset.Length));
    }
}
