using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Sources;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The project's imports, which live as long as its scripts are loaded.</summary>
    [InitializeOnLoad]
    public static class PointCloudImports
    {
        const string Unsaved = "FastPoints.Imports"; // Unsaved requests, during a reload of scripts.

        static EditorImports s_current;
        internal static string[] s_arguments = Environment.GetCommandLineArgs(); // Arguments of the editor; tests set others.

        static PointCloudImports()
        {
            // Import workers load scripts as well, but the only queue is the editor's.
            OwnedEntity.IsImportWorker = AssetDatabase.IsAssetImportWorkerProcess();
            if (OwnedEntity.IsImportWorker)
                return;
            PointCloudPaths.PathOfAsset = AssetDatabase.GUIDToAssetPath;
            FastPointsSettings.instance.Apply();
            PointFileReaders.Register();
            EditorApplication.quitting += Suspend;
            AssemblyReloadEvents.beforeAssemblyReload += Suspend;
            // Undo survives a reload of scripts.
            if (IsMainEditor)
                Undo.undoRedoPerformed += FastPointsSettingsPage.ApplyAfterUndo;
            Listen();
        }

        /// <summary>Whether this editor is the project's own, which alone imports, asks and writes: no import worker, and no
        /// clone of Multiplayer Play Mode, which has its Assets and can only read.</summary>
        internal static bool IsMainEditor => !AssetDatabase.IsAssetImportWorkerProcess() &&
            Array.IndexOf(s_arguments, "--virtual-project-clone") < 0;

        internal static void Listen()
        {
            // Batch mode does not wait for conversions: BatchConvert does.
            if (!Application.isBatchMode && IsMainEditor)
                EditorApplication.update += Update;
        }

        public static EditorImports Current => s_current ?? Open();

        internal static ProjectPaths ConfiguredPaths =>
            new ProjectPaths(Project, FastPointsSettings.instance.Place, FastPointsUserSettings.EffectiveSourceRoot);

        static string Project => Path.GetDirectoryName(Application.dataPath);

        /// <summary>Changes the folder into which clouds are converted from now on. A running conversion is suspended,
        /// and continues when the folder is changed back.</summary>
        /// <returns>Why this is not possible, in one line; null if it is done.</returns>
        public static string SwitchConvertedRoot(string folder)
        {
            string problem = ProjectPaths.FindProblem(Project, folder);
            if (problem != null)
                return problem;
            Begin(() => FastPointsSettings.instance.Place = folder);
            return null;
        }

        static EditorImports Open()
        {
            s_current = new EditorImports(ConfiguredPaths, FastPointsSettings.instance);
            string unsaved = SessionState.GetString(Unsaved, "");
            SessionState.EraseString(Unsaved);
            if (unsaved.Length > 0)
                s_current.Queue.Add(ImportQueue.FromJson(unsaved, Unsaved));
            return s_current;
        }

        static void Close()
        {
            s_current?.Suspend();
            if (s_current?.Queue.Unsaved is { } unsaved)
                SessionState.SetString(Unsaved, ImportQueue.ToJson(unsaved));
            s_current = null;
        }

        static void Begin(Action set)
        {
            Close();
            set();
            FastPointsSettings.instance.Apply();
        }

        internal static void SwitchSourceRoot(string root) => Begin(() => FastPointsUserSettings.instance.SetRoot(root));

        static void Update() => Current.Update(DateTime.UtcNow);

        static void Suspend()
        {
            EditorApplication.update -= Update;
            Close();
        }
    }
}
