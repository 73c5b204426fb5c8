using System;
using System.Collections.Generic;
using System.Text;
using FastPoints.Reading;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Has point cloud files in <c>Assets</c> imported by <see cref="PointFileImporter"/> if the project wants that,
    /// which the user is asked once, also for files older than the package.</summary>
    internal sealed class PointFilePrompt
    {
        const string CheckedKey = "FastPoints.PointFilePrompt";
        const int MaxHeaderBytes = 64 << 10;

        readonly FastPointsSettings m_settings;
        readonly List<string> m_offered = new List<string>();
        PointFiles m_before;

        public PointFilePrompt(FastPointsSettings settings) => (m_settings, m_before) = (settings, settings.PointFiles);

        /// <summary>Assets that were imported by another importer than ours.</summary>
        public void Add(List<string> assets)
        {
            if (m_settings.PointFiles == PointFiles.Leave)
                return;
            m_offered.AddRange(assets.FindAll(IsUnclaimed));
            if (m_settings.PointFiles == PointFiles.Import)
                Claim();
        }

        /// <summary>Called once an update of the editor. Checks all assets once a session, and when the setting
        /// changes.</summary>
        public void Update()
        {
            if (m_before != m_settings.PointFiles || SessionState.GetString(CheckedKey, "") == "")
            {
                SessionState.SetString(CheckedKey, "yes");
                m_before = m_settings.PointFiles;
                AddExisting();
            }
            // A question would interrupt play mode.
            if (m_offered.Count == 0 || m_settings.PointFiles != PointFiles.Ask || Application.isBatchMode ||
                EditorApplication.isPlayingOrWillChangePlaymode)
                return;
            m_settings.PointFiles = EditorUtility.DisplayDialog("Point clouds in Assets", "Shall FastPoints import the LAS, " +
                "LAZ and PLY files in Assets, " + m_offered.Count + " now, that no other package imports? The answer is kept: " +
                "Project Settings > FastPoints changes it.", "Import", "Leave") ? PointFiles.Import : PointFiles.Leave;
            m_before = m_settings.PointFiles;
            m_settings.Save();
            if (m_settings.PointFiles == PointFiles.Import)
                Claim();
            m_offered.Clear();
        }

        public void AddExisting() => Add(new List<string>(AssetDatabase.GetAllAssetPaths()));

        public static bool IsPointFile(string path) =>
            path.StartsWith("Assets/", StringComparison.Ordinal) && CloudSources.HasImportedExtension(path);

        /// <summary>A file that only players read, or a mesh, is no point cloud of the project.</summary>
        static bool IsUnclaimed(string path) => IsPointFile(path) &&
            !path.StartsWith("Assets/StreamingAssets/", StringComparison.OrdinalIgnoreCase) &&
            !path.StartsWith("Assets/Editor Default Resources/", StringComparison.OrdinalIgnoreCase) &&
            AssetDatabase.GetImporterOverride(path) == null &&
            !BelongsToOtherImporter(path, PointCloudImports.ConfiguredPaths.Absolute(path));

        /// <summary>Whether another package's importer is responsible for a file, or it is a mesh.</summary>
        /// <param name="asset">Its path in the project, or what that would be.</param>
        public static bool BelongsToOtherImporter(string asset, string file) =>
            typeof(ScriptedImporter).IsAssignableFrom(AssetDatabase.GetDefaultImporter(asset)) || HasFaces(file);

        static bool HasFaces(string file)
        {
            if (!file.EndsWith(".ply", StringComparison.OrdinalIgnoreCase))
                return false;
            try
            {
                using var source = RandomAccessFile.Open(file);
                // A file without a line end is not read to its end.
                foreach (string line in Encoding.ASCII.GetString(source.ReadUpTo(0, MaxHeaderBytes).Bytes).Split('\n', '\r'))
                {
                    if (line == "end_header")
                        return false;
                    var words = line.Split(' ');
                    if (words.Length > 2 && words[0] == "element" && (words[1] == "face" || words[1] == "tristrips") &&
                        words[2] != "0")
                        return true;
                }
                return false;
            }
            catch (PointCloudException)
            {
                return true;
            }
        }

        void Claim()
        {
            var paths = m_offered.ToArray();
            m_offered.Clear();
            if (paths.Length == 0)
                return;
            PointCloudException refused = null;
            AssetDatabase.StartAssetEditing();
            try
            {
                foreach (string path in paths)
                    refused = TryClaim(path) ?? refused;
            }
            finally
            {
                AssetDatabase.StopAssetEditing();
            }
            if (refused != null)
                Debug.LogWarning("FastPoints: not all point cloud files are imported: " + refused.Message);
        }

        /// <returns>Why not; null if all went well.</returns>
        static PointCloudException TryClaim(string path)
        {
            try
            {
                // Their .meta files name the importer.
                VersionedFile.CheckOut(PointCloudImports.ConfiguredPaths.Absolute(path + ".meta"));
                AssetDatabase.SetImporterOverride<PointFileImporter>(path);
                return null;
            }
            catch (PointCloudException e)
            {
                return e;
            }
        }
    }

    internal enum PointFiles
    {
        Ask,
        Import,
        Leave,
    }
}
