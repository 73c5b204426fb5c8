using System.Collections.Generic;
using FastPoints.Entities;
using FastPoints.Nodes;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    static class FastPointsSettingsPage
    {
        static string s_problem;

        [SettingsProvider]
        static SettingsProvider Create() => new SettingsProvider("Project/FastPoints", SettingsScope.Project,
            new[] { "point cloud", "lidar", "las", "laz", "octree", "sampler", "normals", "memory", "threads", "vram" })
        {
            guiHandler = _ => Draw(FastPointsSettings.instance),
        };

        /// <summary>Undo restores the values, but not their consequences.</summary>
        internal static void ApplyAfterUndo()
        {
            if (PointCloudImports.ConfiguredPaths.Clouds != PointCloudImports.Current.Paths.Clouds)
                PointCloudImports.SwitchConvertedRoot(FastPointsSettings.instance.Place);
            FastPointsSettings.instance.Save();
        }

        static void DrawImports(FastPointsSettings settings)
        {
            settings.PointFiles = (PointFiles)EditorGUILayout.EnumPopup(new GUIContent("LAS, LAZ and PLY files in Assets",
                "Import: those without faces that no other package imports. Ask: the answer is kept here."), settings.PointFiles);
            settings.SeveralFiles = (SeveralFiles)EditorGUILayout.EnumPopup(new GUIContent("Several files dropped together",
                "One cloud, or a cloud each, on a shared origin. Ask: the answer is kept here."), settings.SeveralFiles);
            settings.ConvertAtOnce = EditorGUILayout.Toggle(new GUIContent("Convert what is imported",
                "Otherwise scenes show previews until Convert is pressed in an asset's inspector."), settings.ConvertAtOnce);
            if (settings.ConvertAtOnce)
                settings.ConvertOctrees = EditorGUILayout.Toggle(new GUIContent("COPC, Potree and EPT, too",
                    "Otherwise they are streamed as they are."), settings.ConvertOctrees);
            settings.Sampler = (Sampler)EditorGUILayout.EnumPopup(new GUIContent("Sampler",
                "Which points stand for the others where a cloud is seen from afar."), settings.Sampler);
            settings.Normals = EditorGUILayout.Toggle(new GUIContent("Normals",
                "Computed once a cloud is converted, for light: at most 2 bytes a point."), settings.Normals);
        }

        static void DrawLimits(FastPointsSettings settings)
        {
            settings.MemoryMiB = EditorGUILayout.IntSlider(new GUIContent("Memory of a conversion (MiB)",
                "What does not fit goes to temporary files."), settings.MemoryMiB, 64, 65536);
            settings.Workers = EditorGUILayout.IntSlider(new GUIContent("Worker threads of a conversion (0: all)",
                "Fewer leave workers to other jobs."), settings.Workers, 0, 64);
            settings.InPlayMode = (InPlayMode)EditorGUILayout.EnumPopup(new GUIContent("Conversions in play mode",
                "One worker leaves the others to the game."), settings.InPlayMode);
            settings.UpdateMs = EditorGUILayout.IntSlider(new GUIContent("Main thread of an update (ms)",
                "What a conversion gets of each of the editor's updates; more where they are rare."), settings.UpdateMs, 1, 30);
            settings.GpuMiB = EditorGUILayout.IntSlider(new GUIContent("Graphics memory of points (MiB)",
                "In the editor, in scenes without Point Cloud Settings, which begin with it when added. In players that " +
                "component decides, or 512 MiB."), settings.GpuMiB, 64, 16384);
            settings.MaxCopiedMiB = EditorGUILayout.IntSlider(new GUIContent("Copied into Assets up to (MiB)",
                "What is dropped together and larger stays where it is, and gets handles."), settings.MaxCopiedMiB, 0, 2048);
            settings.PlayerWarningMiB = EditorGUILayout.IntSlider(new GUIContent("Warn of clouds in players from (MiB)",
                "Builds whose point clouds are larger together say so. 0: never."), settings.PlayerWarningMiB, 0, 65536);
            settings.ProgressiveInPlayers = EditorGUILayout.Toggle(new GUIContent("Several frames in players",
                "The shaders for it. Without, players draw all points at once."), settings.ProgressiveInPlayers);
            settings.AlwaysInPlayers = CloudFields(new GUIContent("Always in players",
                "Clouds that only code names. An empty field takes one more."), settings.AlwaysInPlayers);
        }

        /// <summary>A missing asset keeps its row until another replaces it.</summary>
        static string[] CloudFields(GUIContent label, string[] clouds)
        {
            var chosen = new List<string>();
            for (int i = 0; i <= clouds.Length; i++)
            {
                string before = i < clouds.Length ? clouds[i] : null;
                var known = before == null ? null
                    : AssetDatabase.LoadAssetAtPath<PointCloudAsset>(AssetDatabase.GUIDToAssetPath(before));
                var cloud = (PointCloudAsset)EditorGUILayout.ObjectField(i == 0 ? label : new GUIContent(" ", ""), known,
                    typeof(PointCloudAsset), false);
                string guid = cloud != null ? AssetDatabase.AssetPathToGUID(AssetDatabase.GetAssetPath(cloud))
                    : known == null ? before : null;
                if (guid != null && !chosen.Contains(guid))
                    chosen.Add(guid);
            }
            return chosen.ToArray();
        }

        static void Draw(FastPointsSettings settings)
        {
            float width = EditorGUIUtility.labelWidth;
            EditorGUIUtility.labelWidth = 270;
            if (s_problem != null)
                EditorGUILayout.HelpBox(s_problem, MessageType.Error);
            // Unity compares when the event has been handled: without a change nothing is recorded.
            Undo.RecordObject(settings, "Change FastPoints settings");
            EditorGUI.BeginChangeCheck();
            DrawImports(settings);
            DrawLimits(settings);
            settings.GitIgnore = EditorGUILayout.Toggle(new GUIContent("Keep them out of Git",
                "Writes a .gitignore when the folder is made. Clouds can be converted again."), settings.GitIgnore);
            string folder = EditorGUILayout.DelayedTextField(new GUIContent("Converted clouds in",
                "A folder beside Assets, or anywhere else. Clouds converted earlier stay where they are."), settings.Place);
            bool browses = GUILayout.Button("Browse...");
            string root = EditorGUILayout.DelayedTextField(new GUIContent("Root of sources (yours alone)", "Files below it are " +
                "stored relative to it, so that a team shares assets. The variable FASTPOINTS_SOURCES counts for more."),
                FastPointsUserSettings.instance.SourceRoot);
            EditorGUIUtility.labelWidth = width;
            if (root != FastPointsUserSettings.instance.SourceRoot)
                PointCloudImports.SwitchSourceRoot(root);
            bool isChanged = EditorGUI.EndChangeCheck();
            if (browses && EditorUtility.OpenFolderPanel("Converted clouds in", settings.Place, "") is { Length: > 0 } chosen)
                folder = PointCloudImports.ConfiguredPaths.StoredShared(chosen);
            if (isChanged || folder != settings.Place)
                Apply(settings, folder);
            // Other windows were drawn while the panel was open: this one's layout is lost.
            if (browses)
                GUIUtility.ExitGUI();
        }

        static void Apply(FastPointsSettings settings, string folder)
        {
            s_problem = folder == settings.Place ? null : PointCloudImports.SwitchConvertedRoot(folder);
            settings.Save();
        }
    }
}
