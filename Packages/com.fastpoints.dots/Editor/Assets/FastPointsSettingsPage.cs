using FastPoints.Octree;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary><em>Project Settings > FastPoints</em>.</summary>
    static class FastPointsSettingsPage
    {
        [SettingsProvider]
        static SettingsProvider Create() => new SettingsProvider("Project/FastPoints", SettingsScope.Project,
            new[] { "point cloud", "lidar", "las", "laz", "octree", "sampler", "memory" })
        {
            guiHandler = _ => Draw(FastPointsSettings.instance),
        };

        static void Draw(FastPointsSettings settings)
        {
            EditorGUI.BeginChangeCheck();
            settings.ConvertAtOnce = EditorGUILayout.Toggle("Convert what is imported", settings.ConvertAtOnce);
            settings.Sampler = (Sampler)EditorGUILayout.EnumPopup("Sampler", settings.Sampler);
            settings.MemoryMiB = EditorGUILayout.IntSlider("Memory of a conversion (MiB)", settings.MemoryMiB, 64, 65536);
            settings.UpdateMs = EditorGUILayout.IntSlider("Main thread of an update (ms)", settings.UpdateMs, 1, 30);
            settings.CopiedMiB = EditorGUILayout.IntSlider("Copied into Assets up to (MiB)", settings.CopiedMiB, 0, 2048);
            EditorGUILayout.HelpBox("Converted clouds are in " + ProjectPaths.DefaultClouds + ", beside Assets. " +
                "What they need in players is set on Point Cloud Settings, a component.", MessageType.None);
            if (EditorGUI.EndChangeCheck())
                settings.Save();
        }
    }
}
