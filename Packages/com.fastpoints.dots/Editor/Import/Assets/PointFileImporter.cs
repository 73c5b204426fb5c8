using System.Collections.Generic;
using FastPoints.Sources;
using UnityEditor;
using UnityEditor.AssetImporters;

namespace FastPoints.Editor
{
    /// <summary>Imports LAS, LAZ and PLY files in <c>Assets</c> by their headers. Unity never chooses it: two importers that
    /// claim one extension lock each other out, and others claim these. <see cref="CloudAssetPostprocessor"/> chooses it
    /// instead.</summary>
    [ScriptedImporter(Version, null, new[] { "las", "laz", "ply" }, AllowCaching = true)]
    internal sealed class PointFileImporter : CloudImporter
    {
        protected override CloudHandle Describe(AssetImportContext context, string guid)
        {
            using var reader = PointReaders.Open(context.assetPath);
            var handle = new CloudHandle { CloudPath = ProjectPaths.StoredFolderOf(guid) };
            handle.Sources.Add(context.assetPath);
            handle.IsSourceOctree = reader.Tree != null;
            handle.SetFrom(reader.Info);
            foreach (var warning in reader.Info.Warnings)
                context.LogImportWarning(warning.ToString());
            return handle;
        }
    }

    /// <summary>Chooses <see cref="PointFileImporter"/> for point cloud files that no other package's importer handles, and
    /// requests their conversion.</summary>
    internal sealed class CloudAssetPostprocessor : AssetPostprocessor
    {
        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets,
            string[] movedFromAssetPaths)
        {
            if (!PointCloudImports.IsMainEditor)
                return;
            PointCloudImports.Current.UnusedClouds.OnDeleted(deletedAssets);
            PointCloudImports.Current.Assets.Update(importedAssets, deletedAssets, movedFromAssetPaths, movedAssets);
            PointCloudImports.Current.MissingData.OnImported(importedAssets);
            var ours = new List<string>();
            var unclaimed = new List<string>();
            foreach (string path in importedAssets)
                if (PointFilePrompt.IsPointFile(path) && AssetDatabase.GetImporterType(path) == typeof(PointFileImporter))
                    ours.Add(path);
                else
                    unclaimed.Add(path);
            PointCloudImports.Current.CreatePointFileHandles(ours);
            PointCloudImports.Current.PointFilePrompt.Add(unclaimed);
        }
    }
}
