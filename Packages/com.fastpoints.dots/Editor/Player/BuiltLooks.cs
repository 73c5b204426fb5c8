using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using System.Text.RegularExpressions;
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

        /// <summary>How text and binary files name the component that an event calls; text may break the line.</summary>
        static readonly Regex s_eventTarget = new Regex(@"FastPoints\.[\w.]+,\s+FastPoints\.");

        /// <summary>What may hold curves.</summary>
        static readonly string[] s_animations = { ".anim", ".controller", ".playable" };

        readonly List<PointStyle> m_styles = new List<PointStyle> { PointStyle.Default };

        /// <summary>Includes the default: a scene may have no settings.</summary>
        public IReadOnlyList<PointStyle> Styles => m_styles;

        /// <summary>Whether a scene has a clip box.</summary>
        public bool Clips { get; private set; }

        /// <summary>Whether a cloud hides classes.</summary>
        public bool Filters { get; private set; }

        /// <summary>What has an event that calls a component of the package, or a curve of one, so that looks may change; null if
        /// nothing does.</summary>
        public string Changer { get; private set; }

        /// <summary>Examines scenes and prefabs that contain something of the package, and opens no others.</summary>
        /// <param name="scenes">Paths of built scenes.</param>
        /// <param name="assets">Paths of all assets of the player.</param>
        public void Add(IEnumerable<string> scenes, IEnumerable<string> assets)
        {
            foreach (string scene in scenes)
                if (RefersToPackage(scene))
                    AddScene(scene);
            foreach (string asset in assets)
            {
                string kind = Path.GetExtension(asset).ToLowerInvariant();
                bool isPrefab = kind == ".prefab", isAnimation = Array.IndexOf(s_animations, kind) >= 0;
                if (!isPrefab && !isAnimation || !RefersToPackage(asset))
                    continue;
                if (isAnimation)
                    Changer ??= asset;
                else if (AssetDatabase.LoadAssetAtPath<GameObject>(asset) is { } prefab)
                    Add(asset, prefab);
            }
        }

        void AddScene(string path)
        {
            var scene = EditorSceneManager.OpenPreviewScene(path);
            try
            {
                Add(path, scene.GetRootGameObjects());
            }
            finally
            {
                EditorSceneManager.ClosePreviewScene(scene);
            }
        }

        void Add(string path, params GameObject[] roots)
        {
            foreach (var root in roots)
            {
                foreach (var settings in root.GetComponentsInChildren<PointCloudSettings>(true))
                    m_styles.Add(settings.Style);
                foreach (var cloud in root.GetComponentsInChildren<PointCloud>(true))
                    Filters |= cloud.HiddenClasses.Length > 0;
                foreach (var cloud in root.GetComponentsInChildren<PointCloudAuthoring>(true))
                    Filters |= cloud.HiddenClasses.Length > 0;
                Clips |= root.GetComponentsInChildren<PointCloudClipBox>(true).Length > 0;
            }
            // Scripts keep events in fields of any shape: their files are simpler to search.
            if (Changer == null && s_eventTarget.IsMatch(File.ReadAllText(FileUtil.GetPhysicalPath(path), Encoding.ASCII)))
                Changer = path;
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
