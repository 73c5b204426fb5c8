using System;
using System.IO;
using FastPoints.SourceFeeds;
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
            FastPointsSettings.instance.Apply();
            PointFileReaders.Register();
            EditorApplication.update += Update;
            EditorApplication.quitting += Suspend;
            AssemblyReloadEvents.beforeAssemblyReload += Suspend;
        }

        public static EditorImports Current => s_current ??= new EditorImports(Paths, FastPointsSettings.instance);

        /// <summary>As the settings say.</summary>
        internal static ProjectPaths Paths => new ProjectPaths(Project, FastPointsSettings.instance.Place);

        static string Project => Path.GetDirectoryName(Application.dataPath);

        /// <summary>From now on clouds are converted into another place. A conversion that goes on is suspended, and continued
        /// when the
        /// place is what it was.</summary>
        /// <returns>Why not, in one line; null where they are.</returns>
        public static string Move(string place)
        {
            string problem = ProjectPaths.FindProblem(Project, place);
            if (problem != null)
                return problem;
            s_current?.Suspend();
            s_current = null;
            FastPointsSettings.instance.Place = place;
            FastPointsSettings.instance.Apply();
            return null;
        }

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
