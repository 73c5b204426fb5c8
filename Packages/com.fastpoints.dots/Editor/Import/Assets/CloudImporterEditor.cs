using System;
using System.Globalization;
using System.IO;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace FastPoints.Editor
{
    [CustomEditor(typeof(CloudImporter), true)]
    [CanEditMultipleObjects]
    internal sealed class CloudImporterEditor : ScriptedImporterEditor
    {
        static readonly (string Name, double Metres)[] s_units =
            { ("Metres", 1), ("Feet", 0.3048), ("US survey feet", 1200.0 / 3937) };

        CloudHandle m_handle;
        CatalogCloud m_cloud;
        CatalogMatch m_match;
        bool m_wasInQueue;
        string m_message;
        string m_missing;

        public override bool showImportedObject => false;

        string Asset => ((AssetImporter)target).assetPath;

        public override void OnEnable()
        {
            base.OnEnable();
            Refresh();
        }

        public override bool RequiresConstantRepaint() => m_wasInQueue || PointCloudImports.Current.Verification.IsChecking;

        public override void OnInspectorGUI()
        {
            var imports = PointCloudImports.Current;
            // A preset's importer has no file.
            if (string.IsNullOrEmpty(Asset))
            {
                DrawSettings();
                return;
            }
            if (targets.Length > 1)
            {
                DrawSeveral(imports);
                return;
            }
            var request = imports.RequestOf(Asset);
            if (m_wasInQueue && request == null)
                Refresh();
            m_wasInQueue = request != null;
            if (m_handle != null)
            {
                Draw(m_handle, m_cloud);
                DrawMissing(imports);
                if (request != null)
                    DrawRequest(imports, request);
                else
                    DrawConverted(imports);
            }
            if (m_message != null)
                EditorGUILayout.HelpBox(m_message, MessageType.Warning);
            DrawSettings();
        }

        void DrawSeveral(EditorImports imports)
        {
            if (GUILayout.Button("Convert all " + targets.Length))
                imports.Convert(Array.ConvertAll(targets, importer => ((AssetImporter)importer).assetPath));
            DrawSettings();
        }

        void DrawSettings()
        {
            serializedObject.Update();
            EditorGUILayout.PropertyField(serializedObject.FindProperty(nameof(CloudImporter.UpAxis)));
            var metres = serializedObject.FindProperty(nameof(CloudImporter.MetresPerUnit));
            EditorGUILayout.PropertyField(metres);
            if (targets.Length == 1 && m_handle != null && !(metres.doubleValue > 0) && !UnitsOf(m_handle, m_cloud).IsKnown)
                DrawUnits(metres);
            serializedObject.ApplyModifiedProperties();
            ApplyRevertGUI();
        }

        void DrawUnits(SerializedProperty metres)
        {
            EditorGUILayout.HelpBox("Unit unknown: taken for metres. What is it?", MessageType.Warning);
            foreach (var (name, length) in s_units)
                if (GUILayout.Button(name + ": " + SizeOf(BoundsOf(m_handle, m_cloud).Size * length) + " m"))
                    metres.doubleValue = length;
        }

        static CloudUnits UnitsOf(CloudHandle handle, CatalogCloud cloud) => cloud?.Manifest?.Crs.Units ?? handle.Units;

        static BoundsGeo BoundsOf(CloudHandle handle, CatalogCloud cloud) => cloud?.Manifest?.BoundsGeo ?? handle.BoundsGeo;

        static string SizeOf(double3 size) =>
            string.Format(CultureInfo.InvariantCulture, "{0:0.###} x {1:0.###} x {2:0.###}", size.x, size.y, size.z);

        /// <summary>Collects what is drawn, but not at every repaint.</summary>
        void Refresh()
        {
            m_handle = null;
            (m_message, m_missing) = (null, null);
            if (string.IsNullOrEmpty(Asset))
                return;
            try
            {
                var catalog = PointCloudImports.Current.Catalog;
                catalog.Refresh();
                m_handle = PointCloudImports.Current.HandleOf(Asset);
                m_match = catalog.Find(m_handle, out m_cloud);
                m_missing = CloudRelocation.FindMissingSource(m_handle, PointCloudImports.ConfiguredPaths);
                string cloud = PointCloudImports.ConfiguredPaths.Absolute(m_handle.CloudPath);
                if (!File.Exists(CloudThumbnails.PathOf(cloud)))
                    PointCloudImports.Current.AddThumbnail(m_handle);
            }
            catch (PointCloudException e)
            {
                m_message = e.Message;
            }
        }

        static void Draw(CloudHandle handle, CatalogCloud cloud)
        {
            long points = cloud?.Manifest?.Points ?? handle.Points;
            EditorGUILayout.LabelField("Points", points < 0 ? "not counted yet"
                : points.ToString("N0", CultureInfo.InvariantCulture));
            if (handle.Format != null)
                EditorGUILayout.LabelField("Format", handle.Format);
            EditorGUILayout.LabelField("Coordinates", cloud?.Manifest?.CrsName ?? handle.Crs ?? "not known");
            var bounds = BoundsOf(handle, cloud);
            EditorGUILayout.LabelField("Unit", UnitsOf(handle, cloud).Describe(bounds));
            if (!bounds.IsEmpty)
                EditorGUILayout.LabelField("Size (CRS units)", SizeOf(bounds.Size));
            foreach (string source in handle.Sources)
                EditorGUILayout.LabelField("Source", source);
            EditorGUILayout.LabelField("Converted", handle.CloudPath);
            string cloudPath = PointCloudImports.ConfiguredPaths.Absolute(handle.CloudPath);
            if (PointCloudImports.Current.Assets.Of(cloudPath) is { Count: > 1 } users)
                EditorGUILayout.HelpBox("One cloud of several assets: " + string.Join(", ", users), MessageType.Info);
            if (handle.Warnings.Count > 0)
                EditorGUILayout.HelpBox(string.Join("\n", handle.Warnings), MessageType.Warning);
            if (cloud?.Manifest?.Attributes == null)
                return;
            for (int i = 0; i < cloud.Manifest.Attributes.Count; i++)
            {
                var range = cloud.Manifest.Ranges[i];
                EditorGUILayout.LabelField(cloud.Manifest.Attributes[i].Name,
                    NumberText.Of(range.Min) + " to " + NumberText.Of(range.Max));
            }
        }

        void DrawMissing(EditorImports imports)
        {
            if (m_missing == null || target is PointFileImporter)
                return;
            EditorGUILayout.HelpBox("Not there: " + m_missing, MessageType.Warning);
            if (!GUILayout.Button("Locate source..."))
                return;
            CloudRelocation.Prompt(imports, Asset, m_missing);
            Refresh();
            // Other windows were drawn while the panel was open: this one's layout is lost.
            GUIUtility.ExitGUI();
        }

        internal static string Describe(ImportQueue queue, ImportRequest request) =>
            request.State == ImportState.Failed ? request.Failure : request.State == ImportState.Paused ? "paused"
            : request.State == ImportState.Waiting ? "waiting" : ConversionProgress.Describe(queue.Session.Progress);

        static void DrawRequest(EditorImports imports, ImportRequest request)
        {
            var queue = imports.Queue;
            bool isPaused = request.State == ImportState.Paused;
            if (request.State == ImportState.Failed)
                EditorGUILayout.HelpBox(request.Failure, MessageType.Error);
            else
                EditorGUILayout.LabelField("Import", Describe(queue, request));
            if (request.State == ImportState.Failed || isPaused)
            {
                if (GUILayout.Button(isPaused ? "Go on" : "Try again"))
                    queue.Resume(request);
            }
            else if (GUILayout.Button("Pause"))
                queue.Pause(request);
            if (GUILayout.Button("Cancel"))
                imports.Cancel(request);
        }

        void DrawConverted(EditorImports imports)
        {
            bool exists = m_match == CatalogMatch.InPlace, hasSource = m_handle.Sources.Count > 0;
            if (m_match == CatalogMatch.Moved)
                EditorGUILayout.HelpBox("The converted cloud is in " + imports.Paths.Stored(m_cloud.Path) +
                    ": give the folder its name, " + m_handle.CloudPath + ", again.", MessageType.Warning);
            if (m_match == CatalogMatch.Another)
                EditorGUILayout.HelpBox(m_cloud.Problem ?? "There is another cloud in this folder.", MessageType.Warning);
            if (hasSource && GUILayout.Button(exists ? "Convert again" : "Convert"))
                imports.Convert(Asset);
            if (m_handle.Stamp != null && GUILayout.Button("Look whether the source has changed"))
                ShowMessage(m_handle.Stamp.Compare(m_handle.Sources.ConvertAll(imports.Paths.Absolute)));
            if (!exists)
                return;
            var check = imports.Verification.Check;
            if (check != null && check.Path == m_cloud.Path)
                EditorGUILayout.HelpBox(check.Describe(),
                    check.IsDone && !check.Result.Ok ? MessageType.Error : MessageType.Info);
            if (!imports.Verification.IsChecking && GUILayout.Button("Verify"))
                imports.Verification.Begin(m_cloud.Path);
            if (GUILayout.Button("Show the folder"))
                EditorUtility.RevealInFinder(m_cloud.Path);
            // A copy of the asset has the same data.
            if (!hasSource || imports.Assets.Of(m_cloud.Path).Count > 1 || !GUILayout.Button("Delete converted data"))
                return;
            if (EditorUtility.DisplayDialog("Delete converted data", m_cloud.Path, "Delete", "Cancel"))
                Delete(imports);
            GUIUtility.ExitGUI();
        }

        void Delete(EditorImports imports)
        {
            try
            {
                CloudCatalog.Delete(m_cloud.Path);
                imports.DisableAutoConvert(m_cloud.Path);
                Refresh();
                EditorImports.Refresh(Asset);
            }
            catch (PointCloudException e)
            {
                m_message = e.Message;
            }
        }

        void ShowMessage(SourceChange change) => m_message = change == SourceChange.None ? "The source is as it was converted."
            : change == SourceChange.Missing ? "The source is not there." : "The source has changed since it was converted.";
    }
}
