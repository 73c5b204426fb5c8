using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Entities;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Entities;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The inspector of a cloud in a scene: what it is coloured by, which classes it shows, the limits and look of all
    /// clouds, and what the last frame did. F frames it.</summary>
    [CustomEditor(typeof(PointCloud))]
    [CanEditMultipleObjects]
    internal sealed class PointCloudEditor : UnityEditor.Editor
    {
        bool m_showsClasses;
        bool m_showsFrame = true;
        bool m_showsSettings;
        UnityEditor.Editor m_settingsEditor;
        uint m_frame;

        static PointCloudSystemGroup Group => PointCloudSystemGroup.ObjectGroup;

        /// <summary>Repaints while frames are drawn, not when idle.</summary>
        public override bool RequiresConstantRepaint() => m_showsFrame && Group?.Stream != null && Group.Stats.Frame != m_frame;

        public override void OnInspectorGUI()
        {
            if (((PointCloud)target).gameObject.scene.isSubScene)
                EditorGUILayout.HelpBox("A subscene keeps no Point Cloud when it is closed or built: use Point Cloud Authoring.",
                    MessageType.Warning);
            serializedObject.Update();
            DrawPropertiesExcluding(serializedObject, "m_Script", "m_hiddenClasses");
            serializedObject.ApplyModifiedProperties();
            if (RemoteNote((PointCloud)target) is { } note)
                EditorGUILayout.HelpBox(note, MessageType.Info);
            if (targets.Length == 1)
                DrawClasses((PointCloud)target);
            DrawSettings();
            DrawFrame();
        }

        // Null for a cloud that is no web server's.
        internal static string RemoteNote(PointCloud cloud) => cloud.Cloud != null || !SourcePath.IsRemote(cloud.Path) ? null
            : "Remote: read from " + SourcePath.WithoutQuery(cloud.Path) + ", by players too." +
                (cloud.Error != null ? "\n" + cloud.Error : "");

        void OnDisable()
        {
            if (m_settingsEditor != null)
                DestroyImmediate(m_settingsEditor);
        }

        void DrawClasses(PointCloud cloud)
        {
            var hidden = cloud.HiddenClasses;
            m_showsClasses = EditorGUILayout.Foldout(m_showsClasses,
                hidden.Length == 0 ? "Classes" : "Classes (" + hidden.Length + " hidden)", true);
            if (!m_showsClasses)
                return;
            if (!TryGetClasses(cloud, out double min, out double max))
            {
                EditorGUILayout.HelpBox("The cloud has no classification.", MessageType.None);
                return;
            }
            var shown = hidden;
            foreach (int c in ClassFilter.ClassesOf(min, max, hidden))
            {
                bool isShown = EditorGUILayout.ToggleLeft(ClassFilter.Label(c), Array.IndexOf(hidden, c) < 0);
                shown = ClassFilter.Switch(shown, c, isShown);
            }
            if (shown == hidden)
                return;
            Undo.RecordObject(cloud, "Show classes");
            cloud.HiddenClasses = shown;
            EditorUtility.SetDirty(cloud);
        }

        void DrawSettings()
        {
            m_showsSettings = EditorGUILayout.Foldout(m_showsSettings, "Size and budget of all clouds", true);
            if (!m_showsSettings)
                return;
            PointCloudSettings settings = null;
            foreach (var found in Resources.FindObjectsOfTypeAll<PointCloudSettings>())
                settings = found.isActiveAndEnabled ? found : settings;
            if (settings != null)
            {
                CreateCachedEditor(settings, null, ref m_settingsEditor);
                m_settingsEditor.OnInspectorGUI();
            }
            else if (GUILayout.Button("Add Point Cloud Settings"))
                ObjectFactory.AddComponent<PointCloudSettings>(ObjectFactory.CreateGameObject("Point Cloud Settings"));
        }

        void DrawFrame()
        {
            m_showsFrame = EditorGUILayout.Foldout(m_showsFrame, "Last frame, all clouds", true);
            var group = Group;
            if (!m_showsFrame || group?.Stream == null)
                return;
            m_frame = group.Stats.Frame;
            foreach (var line in FrameText.Describe(group.Stats, group.Stream.Settings.Selection.PointBudget,
                group.Stream.Pool.LimitBytes))
                EditorGUILayout.LabelField(line.Key, line.Value);
        }

        /// <returns>Whether the cloud has classes, or may have: then the range is NaN.</returns>
        bool TryGetClasses(PointCloud cloud, out double min, out double max)
        {
            min = max = double.NaN;
            var manifest = ManifestOf(cloud);
            if (manifest == null)
                return true;
            int attribute = manifest.Attributes.IndexOf(AttributeNames.Classification);
            if (attribute < 0)
                return false;
            (min, max) = (manifest.Ranges[attribute].Min, manifest.Ranges[attribute].Max);
            return true;
        }

        /// <summary>Null until the cloud is streamed.</summary>
        CloudManifest ManifestOf(PointCloud cloud)
        {
            var group = Group;
            if (group?.Stream == null || cloud.Entity == Entity.Null ||
                !group.World.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity))
                return null;
            int number = group.World.EntityManager.GetComponentData<StreamedPointCloud>(cloud.Entity).Number;
            return (group.Stream.Clouds[number]?.Source as FolderSource)?.Folder.Manifest;
        }

        // Unity finds these by name.

        bool HasFrameBounds() => TryGetBounds(out _);

        Bounds OnGetFrameBounds()
        {
            TryGetBounds(out var bounds);
            return bounds;
        }

        bool TryGetBounds(out Bounds bounds)
        {
            bool isKnown = false;
            bounds = default;
            foreach (var cloud in targets)
            {
                if (!((PointCloud)cloud).TryGetWorldBounds(out var one))
                    continue;
                if (isKnown)
                    bounds.Encapsulate(one);
                else
                    bounds = one;
                isKnown = true;
            }
            return isKnown;
        }
    }

    internal static class FrameText
    {
        public static List<KeyValuePair<string, string>> Describe(in FrameStats stats, long budgetPoints, long limitBytes)
        {
            return new List<KeyValuePair<string, string>>
            {
                Pair("Points", "{0:N0} drawn of {1:N0} selected, {2:N0} at most", stats.DrawnPoints, stats.SelectedPoints,
                    budgetPoints),
                Pair("Nodes", "{0:N0} drawn, {1:N0} in memory", stats.DrawnNodes, stats.CachedNodes),
                Pair("Graphics memory", "{0:0.0} of {1:0} MiB", stats.PoolBytes / 1048576.0, limitBytes / 1048576.0),
                Pair("Hierarchy", "{0:0.0} MiB", stats.HierarchyBytes / 1048576.0),
                Pair("Reads", stats.IsSettled ? "nothing is missing" : "{0} under way, {1:0.0} MiB in this frame",
                    stats.ReadsInFlight, stats.ReadBytes / 1048576.0),
                Pair("Main thread", "{0:0.00} ms", stats.TotalMs),
            };
        }

        static KeyValuePair<string, string> Pair(string name, string format, params object[] values) =>
            new KeyValuePair<string, string>(name, string.Format(CultureInfo.InvariantCulture, format, values));
    }

    internal static class ClassFilter
    {
        /// <summary>The classes that a cloud may have: all defined ones from its smallest to its largest, and those that are
        /// hidden already.</summary>
        /// <param name="min">Minimum of its classification; NaN if unknown, as is <paramref name="max"/>.</param>
        public static List<int> ClassesOf(double min, double max, int[] hidden)
        {
            bool isKnown = min <= max;
            var classes = new List<int>();
            for (int c = 0; c <= byte.MaxValue; c++)
            {
                bool isPossible = isKnown ? c >= min && c <= max : c < ClassNames.FirstUserDefined;
                bool isNamed = ClassNames.Of(c) != null ||
                    (isKnown && (c == min || c == max || c >= ClassNames.FirstUserDefined));
                if ((isPossible && isNamed) || Array.IndexOf(hidden, c) >= 0)
                    classes.Add(c);
            }
            return classes;
        }

        public static string Label(int c) => NumberText.Of(c) + " " +
            (ClassNames.Of(c) ?? (c < ClassNames.FirstUserDefined ? "reserved" : "of the user"));

        /// <summary>The hidden classes after one was switched, rising; the same array if nothing changes.</summary>
        public static int[] Switch(int[] hidden, int c, bool isShown)
        {
            if (Array.IndexOf(hidden, c) >= 0 == !isShown)
                return hidden;
            var classes = new List<int>(hidden);
            if (isShown)
                classes.RemoveAll(h => h == c);
            else
                classes.Add(c);
            classes.Sort();
            return classes.ToArray();
        }
    }
}
