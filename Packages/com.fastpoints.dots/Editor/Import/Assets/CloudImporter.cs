using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The common base of the importers of handles and of point cloud files. They read only headers of the asset's own
    /// file and use no settings, so that they run in import workers and their results may come from a cache.</summary>
    [HelpPage("editor")]
    internal abstract class CloudImporter : ScriptedImporter
    {
        protected const int Version = 5; // Raised when the imported asset changes.

        [Tooltip("The axis of the file that points up.")]
        public UpAxis UpAxis = UpAxis.Z;

        // Not [Min]: its drawer rounds to a float, and a US survey foot has more digits.
        [Tooltip("Metres of a unit of the file: 0.001 for millimetres. 0 or less: as the file says, else metres.")]
        public double MetresPerUnit;

        /// <summary>Reads the asset's file.</summary>
        /// <param name="guid">The asset's GUID.</param>
        /// <exception cref="PointCloudException">The file is not what its name says.</exception>
        protected abstract CloudHandle Describe(AssetImportContext context, string guid);

        public override void OnImportAsset(AssetImportContext ctx)
        {
            var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
            asset.name = Path.GetFileNameWithoutExtension(ctx.assetPath);
            try
            {
                string guid = AssetDatabase.AssetPathToGUID(ctx.assetPath);
                Fill(asset, Describe(ctx, guid), guid, ctx.assetPath);
            }
            catch (PointCloudException e)
            {
                // The asset still exists, so that references to it stay valid.
                ctx.LogImportError(e.Message);
            }
            ctx.AddObjectToAsset("cloud", asset);
            ctx.SetMainObject(asset);
        }

        void Fill(PointCloudAsset asset, CloudHandle handle, string guid, string assetPath)
        {
            asset.ProjectPath = handle.CloudPath;
            asset.PlayerPath = PlayerPath.Of(handle.CloudPath, guid);
            asset.ProjectSources = handle.Sources.ConvertAll(
                s => s == assetPath ? PointCloudPaths.AssetPrefix + guid : s).ToArray();
            asset.PlayerSource = handle.IsSourceOctree ? PlayerPath.OfSource(handle.Sources[0], guid) : "";
            var origin = OriginOf(handle);
            asset.HasOrigin = origin.HasValue;
            asset.Origin = origin ?? default;
            asset.Up = UpAxis;
            asset.MetresPerUnitOverride = MetresPerUnit;
            asset.Points = handle.Points;
            // Unity's text files cannot store infinity.
            var bounds = handle.BoundsGeo.IsEmpty ? new BoundsGeo(1, -1) : handle.BoundsGeo;
            asset.BoundsMin = bounds.Min;
            asset.BoundsMax = bounds.Max;
            asset.Crs = handle.Crs ?? "";
            (asset.MetresPerUnit, asset.VerticalMetresPerUnit) = (handle.Units.Horizontal, handle.Units.Vertical);
        }

        /// <summary>Where the cloud was first shown; another up axis has another floor.</summary>
        double3? OriginOf(CloudHandle handle) => handle.OriginUp == UpAxis ? handle.Origin
            : handle.BoundsGeo.IsEmpty || !handle.BoundsGeo.IsFinite ? (double3?)null
            : UnityLocalSpace.Of(handle.BoundsGeo, handle.Units, UpAxis).OriginGeo;
    }

    internal static class PlayerPath
    {
        /// <summary>The same path as in the project if the cloud is in the place of converted clouds; otherwise one made of its
        /// name and its asset.</summary>
        /// <param name="guid">The asset's number, which keeps clouds with equal names apart.</param>
        public static string Of(string cloudPath, string guid)
        {
            const string folder = ProjectPaths.DefaultClouds + "/";
            if (cloudPath.StartsWith(PointCloudPaths.ConvertedRootPrefix, StringComparison.Ordinal))
                return folder + cloudPath.Substring(PointCloudPaths.ConvertedRootPrefix.Length);
            if (cloudPath.StartsWith(folder, StringComparison.Ordinal) && cloudPath.IndexOf('/', folder.Length) < 0)
                return cloudPath;
            string name = AssetNaming.Safe(Path.GetFileNameWithoutExtension(cloudPath.TrimEnd('/', '\\')));
            return folder + name + "-" + Short(guid) + StoreFormat.FolderExtension;
        }

        public static string OfSource(string source, string guid) => ProjectPaths.DefaultClouds + "/" + Short(guid) + "/" +
            AssetNaming.Safe(Path.GetFileName(source.TrimEnd('/', '\\')));

        static string Short(string guid) => guid.Substring(0, Math.Min(8, guid.Length));
    }
}
