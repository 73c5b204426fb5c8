using System;
using System.IO;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The project's imports, for as long as its scripts are loaded.</summary>
    [InitializeOnLoad]
    public static class PointCloudImports
    {
        static EditorImports s_current;

        static PointCloudImports()
        {
            // Import workers load scripts as well; there is one queue, the editor's.
            if (AssetDatabase.IsAssetImportWorkerProcess())
                return;
            EditorApplication.update += Update;
            EditorApplication.quitting += Suspend;
            AssemblyReloadEvents.beforeAssemblyReload += Suspend;
        }

        public static EditorImports Current => s_current ??= new EditorImports(
            new ProjectPaths(Path.GetDirectoryName(Application.dataPath)), FastPointsSettings.instance);

        internal static void TakePointFile(string asset)
        {
            if (!AssetDatabase.IsAssetImportWorkerProcess())
                Current.TakePointFile(asset);
        }

        static void Update() => Current.Update(DateTime.UtcNow);

        static void Suspend()
        {
            EditorApplication.update -= Update;
            s_current?.Suspend();
            s_current = null;
        }
    }
}
