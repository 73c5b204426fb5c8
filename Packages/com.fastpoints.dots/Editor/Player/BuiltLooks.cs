using System;
using System.Collections.Generic;
using FastPoints.Entities;
using FastPoints.Rendering;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>What the built scenes, and the prefabs that they refer to, need for drawing points.</summary>
    internal sealed class BuiltLooks
    {
        const string Package = "Packages/com.fastpoints.dots/";

        readonly List<PointStyle> m_styles = new List<PointStyle> { PointStyle.Default };

        /// <summary>Includes the default: a scene may have no settings.</summary>
        public IReadOnlyList<PointStyle> Styles => m_styles;

        /// <summary>Whether a scene has a clip box.</summary>
        public bool Clips { get; private set; }

        /// <summary>Whether a cloud hides classes.</summary>
        public bool Filters { get; private set; }

        /// <summary>Examines scenes and prefabs that contain something of the package, and opens no others.</summary>
        /// <param name="scenes">Paths of built scenes.</param>
        /// <param name="assets">Paths of the other assets of the player.</param>
        public void Add(IEnumerable<string> scenes, IEnumerable<string> assets)
        {
            foreach (string scene in scenes)
                if (RefersToPackage(scene))
                    AddScene(scene);
            foreach (string asset in assets)
                if (asset.EndsWith(".prefab", StringComparison.OrdinalIgnoreCase) && RefersToPackage(asset) &&
                    AssetDatabase.LoadAssetAtPath<GameObject>(asset) is { } prefab)
                    Add(prefab);
        }

        void AddScene(string path)
        {
            var scene = EditorSceneManager.OpenPreviewScene(path);
            try
            {
                foreach (var root in scene.GetRootGameObjects())
                    Add(root);
            }
            finally
            {
                EditorSceneManager.ClosePreviewScene(scene);
            }
        }

        void Add(GameObject root)
        {
            foreach (var settings in root.GetComponentsInChildren<PointCloudSettings>(true))
                m_styles.Add(settings.Style);
            foreach (var cloud in root.GetComponentsInChildren<PointCloud>(true))
                Filters |= cloud.HiddenClasses.Length > 0;
            foreach (var cloud in root.GetComponentsInChildren<PointCloudAuthoring>(true))
                Filters |= cloud.HiddenClasses.Length > 0;
            Clips |= root.GetComponentsInChildren<PointCloudClipBox>(true).Length > 0;
        }

        static bool RefersToPackage(string asset)
        {
            foreach (string path in AssetDatabase.GetDependencies(new[] { asset }, true))
                if (path.StartsWith(Package, StringComparison.Ordinal))
                    return true;
            return false;
        }
    }
}
