using System;
using System.Collections.Generic;
using FastPoints.Entities;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>Which assets of the project have which clouds: collected once, then updated as assets are added, moved and
    /// removed. With a thousand clouds, looking through all of them for each one would take a million loads.</summary>
    internal sealed class CloudAssets
    {
        readonly ProjectPaths m_paths;
        readonly Dictionary<string, string> m_cloudOfAsset = new Dictionary<string, string>(StringComparer.Ordinal);
        readonly Dictionary<string, HashSet<string>> m_assetsOfCloud =
            new Dictionary<string, HashSet<string>>(StringComparer.OrdinalIgnoreCase);
        bool m_isCollected;

        public CloudAssets(ProjectPaths paths) => m_paths = paths;

        /// <summary>Paths of all assets, each with the absolute path of its cloud's folder, which may not exist yet.</summary>
        public IReadOnlyDictionary<string, string> All
        {
            get
            {
                Collect();
                return m_cloudOfAsset;
            }
        }

        public IEnumerable<string> Clouds
        {
            get
            {
                Collect();
                return m_assetsOfCloud.Keys;
            }
        }

        public IReadOnlyCollection<string> Of(string cloud)
        {
            Collect();
            return m_assetsOfCloud.TryGetValue(cloud, out var assets) ? (IReadOnlyCollection<string>)assets : new string[0];
        }

        public void Update(string[] imported, string[] deleted, string[] movedFrom, string[] movedTo)
        {
            if (!m_isCollected)
                return;
            foreach (string asset in deleted)
                Remove(asset);
            foreach (string asset in movedFrom)
                Remove(asset);
            foreach (string asset in movedTo)
                Refresh(asset);
            foreach (string asset in imported)
                Refresh(asset);
        }

        void Collect()
        {
            if (m_isCollected)
                return;
            m_isCollected = true;
            foreach (string guid in AssetDatabase.FindAssets("t:" + nameof(PointCloudAsset)))
                Refresh(AssetDatabase.GUIDToAssetPath(guid));
        }

        void Refresh(string asset)
        {
            Remove(asset);
            if (AssetDatabase.GetMainAssetTypeAtPath(asset) != typeof(PointCloudAsset))
                return;
            string path = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(asset).ProjectPath;
            if (string.IsNullOrEmpty(path))
                return;
            string cloud = m_cloudOfAsset[asset] = m_paths.Absolute(path);
            if (!m_assetsOfCloud.TryGetValue(cloud, out var assets))
                m_assetsOfCloud[cloud] = assets = new HashSet<string>(StringComparer.Ordinal);
            assets.Add(asset);
        }

        void Remove(string asset)
        {
            if (!m_cloudOfAsset.TryGetValue(asset, out string cloud))
                return;
            m_cloudOfAsset.Remove(asset);
            m_assetsOfCloud[cloud].Remove(asset);
            if (m_assetsOfCloud[cloud].Count == 0)
                m_assetsOfCloud.Remove(cloud);
        }
    }
}
