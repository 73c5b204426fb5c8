using System;
using System.Collections.Generic;
using System.Threading;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Asks once for all clouds with sources and without current data, as after a clone or a pull, whether to convert
    /// them, and not again about those that are declined: converted data are not for version control.</summary>
    internal sealed class MissingDataPrompt : IDisposable
    {
        const string CheckedKey = "FastPoints.MissingDataPrompt";
        const int MaxListed = 10; // More names would hide the rest of the Console.

        readonly EditorImports m_imports;
        PoolTask<CloudList> m_search;
        CancellationTokenSource m_cancel;
        bool m_hasWarned;

        public MissingDataPrompt(EditorImports imports) => m_imports = imports;

        internal bool IsSearchPending => m_search != null || SessionState.GetString(CheckedKey, "") == "";

        /// <summary>Assets were imported: perhaps by a pull.</summary>
        public void OnImported(string[] imported)
        {
            if (Array.Exists(imported, asset => asset.EndsWith(CloudHandle.Extension, StringComparison.OrdinalIgnoreCase) &&
                m_imports.Assets.All.ContainsKey(asset) && LacksCurrentData(asset)))
                SessionState.EraseString(CheckedKey);
        }

        /// <summary>Whether a handle's data are missing or older, as far as known.</summary>
        bool LacksCurrentData(string asset)
        {
            try
            {
                return m_imports.Catalog.Find(m_imports.HandleOf(asset), out _) is CatalogMatch.None or CatalogMatch.Another;
            }
            catch (PointCloudException)
            {
                // Its importer has reported that.
                return false;
            }
        }

        /// <summary>Called once an update of the editor. Checks all assets once a session, and when some were imported
        /// without data.</summary>
        public void Update()
        {
            // A question would interrupt play mode.
            if (EditorApplication.isPlayingOrWillChangePlaymode)
                return;
            if (m_search == null)
            {
                if (!IsSearchPending || m_imports.IsCreating || Application.isBatchMode)
                    return;
                SessionState.SetString(CheckedKey, "yes");
                m_cancel = new CancellationTokenSource();
                m_search = CloudList.Begin(m_imports, false, m_cancel.Token);
            }
            else if (m_search.IsDone)
            {
                var search = m_search;
                m_search = null;
                try
                {
                    Prompt(search.Take());
                }
                catch (PointCloudException e)
                {
                    Debug.LogError("FastPoints: " + e.Message);
                }
            }
        }

        /// <summary>Before a reload of scripts: the search is repeated afterwards, so nothing is awaited.</summary>
        public void Dispose()
        {
            if (m_search == null)
                return;
            m_cancel.Cancel();
            m_search = null;
            SessionState.EraseString(CheckedKey);
        }

        void Prompt(CloudList list)
        {
            // Without automatic conversion there is no question either.
            if (!FastPointsSettings.instance.ConvertAtOnce)
                return;
            var wanted = list.Wanted.FindAll(r => !m_imports.IsAutoConvertDisabled(r.Cloud));
            if (wanted.Count == 0)
            {
                Warn(list.Lost);
                return;
            }
            string others = list.Lost.Count == 0 ? "" : "\n\nThe sources of " + list.Lost.Count + " other point clouds are not " +
                "here: FastPoints > Clouds names and locates them.";
            if (EditorUtility.DisplayDialog("Point clouds without data", wanted.Count + " point clouds have their sources " +
                "here, but no converted data or older ones, as after a pull. Convert them now? FastPoints > Clouds does it " +
                "later." + others,
                "Convert", "Not now"))
                m_imports.Convert(wanted.ConvertAll(r => r.Asset));
            else
                foreach (var row in wanted)
                    m_imports.DisableAutoConvert(row.Cloud);
        }

        void Warn(List<CloudList.Row> lost)
        {
            if (lost.Count == 0 || m_hasWarned)
                return;
            m_hasWarned = true;
            var named = lost.GetRange(0, Math.Min(lost.Count, MaxListed))
                .ConvertAll(r => "\n" + r.Asset + ": " + r.MissingSource);
            Debug.LogWarning("FastPoints: " + lost.Count + " point clouds have neither converted data nor their sources here. " +
                "FastPoints > Clouds locates sources." + string.Concat(named) + (lost.Count > MaxListed ? "\n..." : ""));
        }
    }
}
