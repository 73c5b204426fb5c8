using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Store;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>When the user deletes the last asset of a converted cloud, asks whether to delete its data too: once
    /// for all that are deleted together. Assets deleted in other ways, as by a change of branches, keep their
    /// data.</summary>
    internal sealed class UnusedCloudPrompt
    {
        readonly EditorImports m_imports;
        readonly List<string> m_deleting = new List<string>();
        readonly List<string> m_unusedClouds = new List<string>();

        public UnusedCloudPrompt(EditorImports imports) => m_imports = imports;

        public void OnWillDelete(string path)
        {
            // The clouds of deleted assets could not be found later.
            if (m_imports.Assets.All.Count > 0)
                m_deleting.Add(path);
        }

        /// <summary>Assets were deleted that <see cref="CloudAssets"/> still knows.</summary>
        public void OnDeleted(string[] deleted)
        {
            foreach (string asset in deleted)
                if (m_imports.Assets.All.TryGetValue(asset, out string cloud) && m_deleting.Exists(e => asset == e ||
                    asset.StartsWith(e + "/", StringComparison.Ordinal)) && !m_unusedClouds.Contains(cloud))
                    m_unusedClouds.Add(cloud);
            m_deleting.Clear();
        }

        /// <summary>Called once an update of the editor: not while Unity imports.</summary>
        public void Prompt()
        {
            // A question would interrupt play mode.
            if (m_unusedClouds.Count == 0 || EditorApplication.isPlayingOrWillChangePlaymode)
                return;
            foreach (string cloud in m_unusedClouds)
                if (!CloudFolder.IsCloud(cloud) && m_imports.Assets.Of(cloud).Count == 0 &&
                    m_imports.Queue.RequestOfCloud(cloud) is { } request)
                    m_imports.Queue.Cancel(request);
            var clouds = m_unusedClouds.FindAll(c => CloudFolder.IsCloud(c) && m_imports.Assets.Of(c).Count == 0 &&
                string.Equals(Path.GetDirectoryName(c), m_imports.Paths.Clouds, StringComparison.OrdinalIgnoreCase));
            m_unusedClouds.Clear();
            if (clouds.Count > 0 && EditorUtility.DisplayDialog("Delete converted data", "No asset has the converted data any " +
                "more of:\n" + string.Join("\n", clouds.ConvertAll(Path.GetFileName)), "Delete data", "Keep"))
                foreach (string cloud in clouds)
                    Delete(cloud);
        }

        void Delete(string cloud)
        {
            try
            {
                if (m_imports.Queue.RequestOfCloud(cloud) is { } request)
                    m_imports.Queue.Cancel(request);
                CloudCatalog.Delete(cloud);
            }
            catch (PointCloudException e)
            {
                Debug.LogError("FastPoints: " + e.Message);
            }
        }
    }

    /// <summary>Receives what the user deletes, before it is deleted.</summary>
    internal sealed class CloudDeletions : AssetModificationProcessor
    {
        // Unity finds it by name.
        static AssetDeleteResult OnWillDeleteAsset(string path, RemoveAssetOptions options)
        {
            if (!Application.isBatchMode)
                PointCloudImports.Current.UnusedClouds.OnWillDelete(path);
            return AssetDeleteResult.DidNotDelete;
        }
    }
}
