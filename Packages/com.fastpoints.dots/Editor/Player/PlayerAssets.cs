using System;
using System.Collections.Generic;
using FastPoints.Entities;
using UnityEditor;
using UnityEngine.SceneManagement;

namespace FastPoints.Editor
{
    /// <summary>Finds the assets that go into a player.</summary>
    static class PlayerAssets
    {
        static readonly string[] s_ofResources = { "t:" + nameof(PointCloudAsset), "t:Prefab" };

        /// <summary>The scenes that a player is built from: if none are named, Unity builds the open one.</summary>
        /// <returns>Their paths; empty for an open scene that was never saved, which Entities does not build.</returns>
        public static string[] ScenesOf(BuildPlayerOptions options)
        {
            if (options.scenes != null && options.scenes.Length > 0)
                return options.scenes;
            string open = SceneManager.GetActiveScene().path;
            return string.IsNullOrEmpty(open) ? Array.Empty<string>() : new[] { open };
        }

        /// <summary>The assets that scenes refer to, clouds and prefabs that Unity adds to any player, and clouds that the
        /// project's settings name.</summary>
        /// <returns>Their paths.</returns>
        public static HashSet<string> Of(string[] scenes)
        {
            var roots = new List<string>(scenes);
            foreach (string type in s_ofResources)
                foreach (string guid in AssetDatabase.FindAssets(type))
                {
                    string path = AssetDatabase.GUIDToAssetPath(guid);
                    if (path.IndexOf("/Resources/", StringComparison.Ordinal) >= 0)
                        roots.Add(path);
                }
            foreach (var cloud in FastPointsSettings.instance.AlwaysInPlayers)
                if (cloud != null)
                    roots.Add(AssetDatabase.GetAssetPath(cloud));
            return new HashSet<string>(AssetDatabase.GetDependencies(roots.ToArray(), true));
        }
    }
}
