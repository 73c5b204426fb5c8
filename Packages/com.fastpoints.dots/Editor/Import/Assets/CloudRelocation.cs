using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    internal static class CloudRelocation
    {
        /// <summary>The first missing source of a handle; null if none is.</summary>
        public static string FindMissingSource(CloudHandle handle, ProjectPaths paths) =>
            handle.Sources.ConvertAll(paths.Absolute).Find(s => !File.Exists(s) && !Directory.Exists(s));

        /// <summary>Asks the user where a source is, and whether to update other assets whose sources moved along.</summary>
        /// <exception cref="PointCloudException">The handle cannot be read.</exception>
        public static void Prompt(EditorImports imports, string asset, string missing)
        {
            string name = Path.GetFileName(missing);
            string found = imports.HandleOf(asset).IsSourceFolder || !Path.HasExtension(name)
                ? EditorUtility.OpenFolderPanel("Locate " + name, "", "")
                : EditorUtility.OpenFilePanelWithFilters("Locate " + name, "", new[] { "All files", "*" });
            if (string.IsNullOrEmpty(found))
                return;
            var move = new SourceMove(missing, Path.GetFullPath(found));
            var others = new List<string>(imports.Assets.All.Keys);
            others.RemoveAll(o => o == asset || !o.EndsWith(CloudHandle.Extension, StringComparison.OrdinalIgnoreCase) ||
                !TryMove(imports, o, move, false));
            if (others.Count > 0 && !EditorUtility.DisplayDialog("Locate source", "The sources of " + others.Count +
                " other assets have moved along.", "Locate them, too", "This one alone"))
                others.Clear();
            others.Add(asset);
            Move(imports, others, move);
        }

        static void Move(EditorImports imports, List<string> assets, SourceMove move)
        {
            AssetDatabase.StartAssetEditing();
            try
            {
                foreach (string asset in assets)
                    if (TryMove(imports, asset, move, true))
                        AssetDatabase.ImportAsset(asset);
            }
            finally
            {
                AssetDatabase.StopAssetEditing();
            }
            foreach (string asset in assets)
                EditorImports.Refresh(asset);
        }

        static bool TryMove(EditorImports imports, string asset, SourceMove move, bool writes)
        {
            try
            {
                var handle = imports.HandleOf(asset);
                bool isMoved = false;
                for (int i = 0; i < handle.Sources.Count; i++)
                    if (move.Find(imports.Paths.Absolute(handle.Sources[i])) is { } to)
                        (handle.Sources[i], isMoved) = (imports.Paths.Stored(to), true);
                if (!isMoved || !writes)
                    return isMoved;
                HandleFile.Write(imports.Paths.Absolute(asset), handle);
                if (handle.Stamp?.Compare(handle.Sources.ConvertAll(imports.Paths.Absolute)) == SourceChange.Changed)
                    Debug.LogWarning("FastPoints: " + asset + " was converted of another file than was located now: its " +
                        "inspector converts it again");
                return true;
            }
            catch (PointCloudException e)
            {
                Debug.LogError("FastPoints: " + e.Message);
                return false;
            }
        }
    }

    /// <summary>A move of sources, inferred from one that was found again: files beside it, or in folders of its
    /// path with unchanged names, have moved along.</summary>
    internal sealed class SourceMove
    {
        readonly string m_from;
        readonly string m_to;

        public SourceMove(string from, string to)
        {
            (m_from, m_to) = (from, to);
            while (Path.GetFileName(m_from) == Path.GetFileName(m_to) && Path.GetDirectoryName(m_from) is { } fromFolder &&
                Path.GetDirectoryName(m_to) is { } toFolder && fromFolder.Length > 1 && toFolder.Length > 1)
                (m_from, m_to) = (fromFolder, toFolder);
        }

        /// <summary>The new path of a source that has moved along; null for one that has not moved, or is missing too.</summary>
        public string Find(string source)
        {
            if (Exists(source))
                return null;
            string to = source == m_from ? m_to
                : source.StartsWith(m_from + Path.DirectorySeparatorChar, StringComparison.Ordinal)
                ? m_to + source.Substring(m_from.Length) : null;
            return to != null && Exists(to) ? to : null;
        }

        static bool Exists(string path) => File.Exists(path) || Directory.Exists(path);
    }
}
