using System;
using System.Collections.Generic;
using FastPoints.Entities;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>What goes into a player.</summary>
    static class PlayerAssets
    {
        static readonly string[] s_ofResources = { "t:" + nameof(PointCloudAsset), "t:Prefab" };

        /// <summary>What scenes refer to, and clouds and prefabs that Unity adds to any player.</summary>
        /// <returns>Paths.</returns>
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
            return new HashSet<string>(AssetDatabase.GetDependencies(roots.ToArray(), true));
        }
    }
}
