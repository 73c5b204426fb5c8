using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Store;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The menu item <em>Assets > Import sample point cloud</em>: a small scan of a street, for samples and for users
    /// without a scan at hand. The package has it as LAZ; it is imported like any other file.</summary>
    internal static class SampleScan
    {
        public const string AssetPath = "Assets/street.pointcloud";

        /// <summary>In the package, where Unity imports nothing; the sample's players have it as a TextAsset.</summary>
        public const string PackagedPath = "Packages/com.fastpoints.dots/Samples~/RunTimeLoading/street.laz.bytes";

        [MenuItem("Assets/Import sample point cloud", false, 21)]
        static void Import()
        {
            var asset = GetOrImport();
            if (asset != null)
                Selection.activeObject = asset;
        }

        /// <summary>Gets the sample's asset, which is made first if it does not exist; null if it cannot be made, which is
        /// logged.</summary>
        public static PointCloudAsset GetOrImport()
        {
            var imports = PointCloudImports.Current;
            string source = imports.Paths.Absolute(ProjectPaths.DefaultClouds + "/street.laz");
            var asset = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(AssetPath);
            // A clone of the project has the asset alone.
            if (asset != null && (File.Exists(source) || CloudFolder.IsCloud(imports.Paths.Absolute(asset.ProjectPath))))
                return asset;
            try
            {
                imports.TryCreateIgnoredFolder(Path.GetDirectoryName(source));
                Directory.CreateDirectory(Path.GetDirectoryName(source));
                if (!File.Exists(source))
                    Copy(Path.GetFullPath(FileUtil.GetPhysicalPath(PackagedPath)), source);
            }
            catch (Exception e)
            {
                Debug.LogError("FastPoints: " + PointCloudException.Of(source, e).FullMessage);
                return null;
            }
            if (asset == null)
                return imports.CreateAsset(source, Path.GetDirectoryName(AssetPath));
            imports.Convert(AssetPath);
            return asset;
        }

        static void Copy(string from, string to)
        {
            File.WriteAllBytes(to + ".tmp", File.ReadAllBytes(from));
            FileChanges.Replace(to + ".tmp", to);
        }
    }
}
