using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Threading;
using FastPoints.Entities;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The window <em>FastPoints > Clouds</em>: what is being converted, in its order, all clouds with their sizes, and
    /// those that nothing uses.</summary>
    internal sealed class CloudsWindow : EditorWindow
    {
        const int RowsPerPage = 200, MaxListedRequests = 50; // More would make each repaint slow.

        PoolTask<CloudList> m_collecting;
        CancellationTokenSource m_cancel;
        CloudList m_list;
        Vector2 m_scroll;
        string m_shown;
        int m_page;

        [MenuItem("FastPoints/Clouds", false, 1)]
        static void Open() => GetWindow<CloudsWindow>("Point clouds");

        internal void Collect() => m_collecting ??=
            CloudList.Begin(PointCloudImports.Current, true, (m_cancel = new CancellationTokenSource()).Token);

        // Unity finds these by name.

        void OnEnable() => m_shown = null;

        void OnDisable()
        {
            m_cancel?.Cancel();
            m_collecting = null;
        }

        void OnInspectorUpdate() => Repaint();

        void OnGUI()
        {
            // What is drawn stays the same until the next layout.
            if (Event.current.type == EventType.Layout)
                Refresh();
            DrawQueue(PointCloudImports.Current);
            if (GUILayout.Button("Look again"))
                m_shown = null;
            if (m_list == null)
                return;
            if (m_list.Wanted.Count > 0 && GUILayout.Button("Convert all missing (" + m_list.Wanted.Count + ")"))
                Convert(m_list.Wanted);
            m_scroll = EditorGUILayout.BeginScrollView(m_scroll);
            int pages = Math.Max(1, (m_list.Rows.Count + RowsPerPage - 1) / RowsPerPage), first = RowsPerPage * m_page;
            for (int i = first; i < Math.Min(first + RowsPerPage, m_list.Rows.Count); i++)
                Draw(m_list.Rows[i]);
            if (pages > 1 && GUILayout.Button("Page " + (m_page + 1) + " of " + pages + ": next"))
                m_page = (m_page + 1) % pages;
            DrawUnused();
            EditorGUILayout.EndScrollView();
        }

        void Refresh()
        {
            var imports = PointCloudImports.Current;
            string now = imports.Assets.All.Count + " " + imports.Queue.Requests.Count;
            if (now != m_shown)
                Collect();
            m_shown = now;
            if (m_collecting == null || !m_collecting.IsDone)
                return;
            var collected = m_collecting;
            m_collecting = null;
            try
            {
                m_list = collected.Take();
                m_page = Math.Min(m_page, Math.Max(0, m_list.Rows.Count - 1) / RowsPerPage);
            }
            catch (PointCloudException e)
            {
                Debug.LogError("FastPoints: " + e.Message);
            }
        }

        static void DrawQueue(EditorImports imports)
        {
            if (imports.Queue.Problem != null)
                EditorGUILayout.HelpBox(imports.Queue.Problem, MessageType.Warning);
            int number = 0;
            // Buttons change the queue.
            foreach (var request in new List<ImportRequest>(imports.Queue.Requests))
            {
                if (number == MaxListedRequests)
                {
                    GUILayout.Label((imports.Queue.Requests.Count - MaxListedRequests) + " more wait");
                    break;
                }
                EditorGUILayout.LabelField(++number + ". " + AssetDatabase.GUIDToAssetPath(request.AssetGuid),
                    CloudImporterEditor.Describe(imports.Queue, request));
                GUILayout.BeginHorizontal();
                if (request != imports.Queue.CurrentRequest && GUILayout.Button("Next"))
                    imports.Queue.MoveFirst(request);
                if (GUILayout.Button("Cancel " + number))
                    imports.Cancel(request);
                GUILayout.EndHorizontal();
            }
        }

        void Convert(List<CloudList.Row> rows)
        {
            PointCloudImports.Current.Convert(rows.ConvertAll(r => r.Asset));
            m_shown = null;
        }

        void Draw(in CloudList.Row row)
        {
            EditorGUILayout.LabelField(row.Asset, Text(row));
            GUILayout.BeginHorizontal();
            if (GUILayout.Button("Select"))
                Selection.activeObject = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(row.Asset);
            if (row.IsWanted && GUILayout.Button("Convert"))
                Convert(new List<CloudList.Row> { row });
            if (row.MissingSource != null && GUILayout.Button("Locate source..."))
            {
                m_shown = null;
                CloudRelocation.Prompt(PointCloudImports.Current, row.Asset, row.MissingSource);
                // Other windows were drawn while the panel was open: this one's layout is lost.
                GUIUtility.ExitGUI();
            }
            if (row.IsConverted && GUILayout.Button("Verify"))
                PointCloudImports.Current.Verification.Begin(row.Cloud);
            if (row.IsConverted && GUILayout.Button("Export..."))
            {
                if (EditorUtility.OpenFolderPanel("Export point cloud into a folder", "", "") is { Length: > 0 } folder)
                    PointCloudImports.Current.Transfers.ExportCopy(row.Cloud, folder);
                GUIUtility.ExitGUI();
            }
            GUILayout.EndHorizontal();
        }

        void DrawUnused()
        {
            if (m_list.Unused.Count == 0)
                return;
            long bytes = 0;
            foreach (var row in m_list.Unused)
            {
                EditorGUILayout.LabelField(Path.GetFileName(row.Cloud), Text(row));
                bytes += row.Bytes;
            }
            if (!GUILayout.Button("Delete unused"))
                return;
            if (EditorUtility.DisplayDialog("Delete unused", m_list.Unused.Count + " converted clouds that no asset has, " +
                Size(bytes) + ". They can be converted again of their sources alone.", "Delete", "Cancel"))
                DeleteUnused();
            GUIUtility.ExitGUI();
        }

        void DeleteUnused()
        {
            var imports = PointCloudImports.Current;
            m_shown = null;
            foreach (var row in m_list.Unused)
            {
                // An asset may have been added since.
                if (imports.Assets.Of(row.Cloud).Count > 0 || imports.Queue.RequestOfCloud(row.Cloud) != null)
                    continue;
                try
                {
                    CloudCatalog.Delete(row.Cloud);
                }
                catch (PointCloudException e)
                {
                    Debug.LogError("FastPoints: " + e.Message);
                }
            }
        }

        static string Text(in CloudList.Row row) =>
            (row.MissingSource != null ? "source is not there (" + row.MissingSource + "), " : "") + row.State +
            (row.Points < 0 ? "" : ", " + row.Points.ToString("N0", CultureInfo.InvariantCulture) + " points") +
            (row.Bytes == 0 ? "" : ", " + Size(row.Bytes));

        static string Size(long bytes) => (bytes * 1e-6).ToString("0.0", CultureInfo.InvariantCulture) + " MB";
    }
}
