using System;
using UnityEditor;
using UnityEditor.AssetImporters;

namespace FastPoints.Editor
{
    /// <summary>Chooses <see cref="PointFileImporter"/> for point cloud files that no other package's importer is in charge of,
    /// and has them converted.</summary>
    public sealed class PointFilePostprocessor : AssetPostprocessor
    {
        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets,
            string[] movedFromAssetPaths)
        {
            foreach (string path in importedAssets)
            {
                if (!IsPointFile(path))
                    continue;
                if (AssetDatabase.GetImporterType(path) == typeof(PointFileImporter))
                    PointCloudImports.TakePointFile(path);
                else if (AssetDatabase.GetImporterOverride(path) == null &&
                    !typeof(ScriptedImporter).IsAssignableFrom(AssetDatabase.GetDefaultImporter(path)))
                    AssetDatabase.SetImporterOverride<PointFileImporter>(path);
            }
        }

        static bool IsPointFile(string path) =>
            path.StartsWith("Assets/", StringComparison.Ordinal) && CloudSources.HasImportedExtension(path);
    }
}
