using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Entities;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace FastPoints.Editor
{
    /// <summary>Handles drops into the Project window, the Scene view and the Hierarchy. Unity copies and hashes any file that is
    /// dropped into the Project window before an importer sees it, so large ones and folders get a handle instead.</summary>
    [InitializeOnLoad]
    public static class PointCloudDrops
    {
        static readonly TimeSpan s_cacheTime = TimeSpan.FromSeconds(1);

        static (string[] Paths, DropKind Kind, DateTime Utc) s_dragged;

        static PointCloudDrops()
        {
            if (!PointCloudImports.IsMainEditor)
                return;
            DragAndDrop.SceneDropHandler onScene = (_, position, _, parent, perform) => OnScene(position, parent, perform);
#if UNITY_6000_3_OR_NEWER
            DragAndDrop.ProjectBrowserDropHandlerV2 onProject = (_, path, perform) => OnProject(path, perform);
            DragAndDrop.HierarchyDropHandlerV2 onHierarchy = (id, flags, parent, perform) => OnScene(DropTarget.Of(
                EditorUtility.EntityIdToObject(id) as GameObject, flags, parent, SceneOf(id.GetHashCode())), perform);
            DragAndDrop.AddDropHandlerV2(onProject);
            DragAndDrop.AddDropHandlerV2(onHierarchy);
            DragAndDrop.AddDropHandlerV2(onScene);
#else
            DragAndDrop.ProjectBrowserDropHandler onProject = (_, path, perform) => OnProject(path, perform);
            DragAndDrop.HierarchyDropHandler onHierarchy = (id, flags, parent, perform) => OnScene(DropTarget.Of(
                EditorUtility.InstanceIDToObject(id) as GameObject, flags, parent, SceneOf(id.GetHashCode())), perform);
            DragAndDrop.AddDropHandler(onProject);
            DragAndDrop.AddDropHandler(onHierarchy);
            DragAndDrop.AddDropHandler(onScene);
#endif
        }

        /// <summary>Returning None leaves the drop to other handlers, Unity's last.</summary>
        public static DragAndDropVisualMode OnProject(string path, bool perform)
        {
            var imports = PointCloudImports.Current;
            // Folders of packages outside the project do not exist in it.
            if (KindOf(imports, perform) != DropKind.Handle ||
                !Directory.Exists(imports.Paths.Absolute(FolderOf(path))))
                return DragAndDropVisualMode.None;
            if (perform)
            {
                DragAndDrop.AcceptDrag();
                Import(FolderOf(path), null);
            }
            return DragAndDropVisualMode.Link;
        }

        /// <summary>Accepts clouds of the project, or files that can become some.</summary>
        public static DragAndDropVisualMode OnScene(Vector3? position, Transform parent, bool perform) =>
            OnScene(
                new DropTarget { Point = position, Parent = parent, Scene = parent != null ? parent.gameObject.scene : default },
                perform);

        internal static DragAndDropVisualMode OnScene(DropTarget target, bool perform)
        {
            var assets = new List<PointCloudAsset>();
            foreach (var dragged in DragAndDrop.objectReferences)
                if (dragged is PointCloudAsset asset)
                    assets.Add(asset);
            var imports = PointCloudImports.Current;
            bool isFiles = assets.Count == 0 && KindOf(imports, perform) != DropKind.None;
            if (assets.Count == 0 && !isFiles)
                return DragAndDropVisualMode.None;
            if (!perform)
                return DragAndDropVisualMode.Copy;
            DragAndDrop.AcceptDrag();
            if (isFiles)
                Import("Assets", target);
            target.AddToScene(assets);
            return DragAndDropVisualMode.Copy;
        }

        /// <summary>Makes a GameObject for a cloud; Undo removes it.</summary>
        /// <returns>Null in a subscene, where it has a <see cref="PointCloudAuthoring"/>.</returns>
        public static PointCloud AddToScene(PointCloudAsset asset, Vector3? position, Transform parent) =>
            new DropTarget { Point = position, Parent = parent }.AddToScene(new[] { asset })?.GetComponent<PointCloud>();

        static void Import(string folder, DropTarget target)
        {
            var imports = PointCloudImports.Current;
            if (DragAndDrop.paths.Length > 1)
                imports.CreateAsset(DragAndDrop.paths, folder, target);
            else if (imports.CreateAsset(DragAndDrop.paths[0], folder) is { } asset)
                target?.AddToScene(new[] { asset });
        }

        /// <summary>Of the dragged files. A drag has some sixty events a second: files are inspected once.</summary>
        static DropKind KindOf(EditorImports imports, bool perform)
        {
            var (paths, now) = (DragAndDrop.paths, DateTime.UtcNow);
            if (perform || now - s_dragged.Utc > s_cacheTime || !paths.SequenceEqual(s_dragged.Paths))
                s_dragged = (paths, CloudSources.DropKindOf(paths, imports.Paths, imports.MaxCopiedBytes), now);
            s_dragged.Utc = now;
            return s_dragged.Kind;
        }

        /// <summary>The scene whose header in the Hierarchy has this instance ID.</summary>
        static Scene SceneOf(int handle)
        {
            for (int i = 0; i < SceneManager.sceneCount; i++)
                if (SceneManager.GetSceneAt(i).handle.GetHashCode() == handle)
                    return SceneManager.GetSceneAt(i);
            return default;
        }

        /// <summary>The folder for a drop target: a folder, an asset in it, or the window's empty part.</summary>
        static string FolderOf(string path) => string.IsNullOrEmpty(path) ? "Assets"
            : AssetDatabase.IsValidFolder(path) ? path : Path.GetDirectoryName(path);
    }
}
