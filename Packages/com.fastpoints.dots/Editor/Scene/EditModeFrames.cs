using System;
using FastPoints.Entities;
using FastPoints.Store;
using UnityEditor;
using UnityEditorInternal;

namespace FastPoints.Editor
{
    /// <summary>Makes frames in edit mode, where worlds are updated only when something in the scene changes: clouds that are
    /// loading need frames of their own, and views that are redrawn. In paused play mode views are drawn and no world is updated:
    /// only streaming continues.</summary>
    [InitializeOnLoad]
    internal static class EditModeFrames
    {
        static readonly TimeSpan s_pollInterval = TimeSpan.FromSeconds(1);

        static int s_requested;
        static int s_edits; // Clouds notice them in frames.
        static DateTime s_polled;

        static EditModeFrames()
        {
            if (AssetDatabase.IsAssetImportWorkerProcess())
                return;
            HttpFile.Register();
            EditorApplication.update += Update;
            // Components notice in their updates how their fields have changed.
            Undo.undoRedoPerformed += EditorApplication.QueuePlayerLoopUpdate;
        }

        public static void Update()
        {
            var group = PointCloudSystemGroup.ObjectGroup;
            bool needsFrame = group != null && (group.NeedsFrame || IsPollDue(group) || s_edits != EditJournal.Changes);
            s_edits = EditJournal.Changes;
            if (EditorApplication.isPlaying)
            {
                if (EditorApplication.isPaused && needsFrame)
                {
                    group.Update();
                    InternalEditorUtility.RepaintAllViews();
                }
                return;
            }
            if (!needsFrame && s_requested == 0)
                return;
            s_requested = Math.Max(0, s_requested - 1);
            EditorApplication.QueuePlayerLoopUpdate();
            SceneView.RepaintAll();
        }

        /// <summary>Whether it is time for a frame in which clouds poll for newer data on disk.</summary>
        static bool IsPollDue(PointCloudSystemGroup group)
        {
            var now = DateTime.UtcNow;
            if (now - s_polled < s_pollInterval)
                return false;
            s_polled = now;
            var imports = PointCloudImports.Current;
            return group.IsFollowing || imports?.Queue.CurrentRequest is { } running &&
                group.IsShown(imports.Paths.Absolute(running.Cloud));
        }

        /// <summary>Asks for a frame, and for a picture after it.</summary>
        public static void RequestFrame() => s_requested = 2;
    }
}
