using System.Collections.Generic;
using System.IO;
using FastPoints.Entities;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Handles drops into the Project window, the Scene view and the Hierarchy. Unity copies and hashes any file that is
    /// dropped into the Project window before an importer sees it, so large ones and folders get a handle instead.</summary>
    [InitializeOnLoad]
    public static class PointCloudDrops
    {
        static PointCloudDrops()
        {
            if (AssetDatabase.IsAssetImportWorkerProcess())
                return;
#if UNITY_6000_3_OR_NEWER
            DragAndDrop.ProjectBrowserDropHandlerV2 onProject = (_, path, perform) => OnProject(path, perform);
            DragAndDrop.HierarchyDropHandlerV2 onHierarchy = (_, _, parent, perform) => OnScene(null, parent, perform);
            DragAndDrop.SceneDropHandler onScene = (_, place, _, parent, perform) => OnScene(place, parent, perform);
            DragAndDrop.AddDropHandlerV2(onProject);
            DragAndDrop.AddDropHandlerV2(onHierarchy);
            DragAndDrop.AddDropHandlerV2(onScene);
#else
            DragAndDrop.ProjectBrowserDropHandler onProject = (_, path, perform) => OnProject(path, perform);
            DragAndDrop.HierarchyDropHandler onHierarchy = (_, _, parent, perform) => OnScene(null, parent, perform);
            DragAndDrop.SceneDropHandler onScene = (_, place, _, parent, perform) => OnScene(place, parent, perform);
            DragAndDrop.AddDropHandler(onProject);
            DragAndDrop.AddDropHandler(onHierarchy);
            DragAndDrop.AddDropHandler(onScene);
#endif
        }

        /// <summary>Returning None leaves the drop to other handlers, Unity's last.</summary>
        public static DragAndDropVisualMode OnProject(string path, bool perform)
        {
            var imports = PointCloudImports.Current;
            if (CloudSources.Of(DragAndDrop.paths, imports.Paths, imports.MostCopiedBytes) != DropKind.Handle)
                return DragAndDropVisualMode.None;
            if (perform)
            {
                DragAndDrop.AcceptDrag();
                foreach (string source in DragAndDrop.paths)
                    imports.Take(source, FolderOf(path));
            }
            return DragAndDropVisualMode.Link;
        }

        /// <summary>Accepts clouds of the project, or files that can become some.</summary>
        public static DragAndDropVisualMode OnScene(Vector3? place, Transform parent, bool perform)
        {
            var assets = new List<PointCloudAsset>();
            foreach (var dragged in DragAndDrop.objectReferences)
                if (dragged is PointCloudAsset asset)
                    assets.Add(asset);
            var imports = PointCloudImports.Current;
            bool isFiles = assets.Count == 0 &&
                CloudSources.Of(DragAndDrop.paths, imports.Paths, imports.MostCopiedBytes) != DropKind.NotOurs;
            if (assets.Count == 0 && !isFiles)
                return DragAndDropVisualMode.None;
            if (perform)
            {
                DragAndDrop.AcceptDrag();
                if (isFiles)
                    foreach (string source in DragAndDrop.paths)
                        assets.Add(imports.Take(source, "Assets"));
                foreach (var asset in assets)
                    if (asset != null)
                        Show(asset, place, parent);
            }
            return DragAndDropVisualMode.Copy;
        }

        /// <summary>Makes a GameObject for a cloud; Undo removes it.</summary>
        public static PointCloud Show(PointCloudAsset asset, Vector3? place, Transform parent)
        {
            var scene = ObjectFactory.CreateGameObject(asset.name);
            if (parent != null)
                scene.transform.SetParent(parent, false);
            if (place.HasValue)
                scene.transform.position = place.Value;
            var cloud = ObjectFactory.AddComponent<PointCloud>(scene);
            cloud.Cloud = asset;
            Selection.activeObject = scene;
            return cloud;
        }

        /// <summary>The folder for a drop target: a folder, an asset in it, or the window's empty part.</summary>
        static string FolderOf(string path) => string.IsNullOrEmpty(path) ? "Assets"
            : AssetDatabase.IsValidFolder(path) ? path : Path.GetDirectoryName(path);
    }
}
