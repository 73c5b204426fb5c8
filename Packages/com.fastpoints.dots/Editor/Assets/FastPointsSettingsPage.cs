using FastPoints.Samplers;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>The page <em>Project Settings > FastPoints</em>.</summary>
    static class FastPointsSettingsPage
    {
        static string s_problem;

        [SettingsProvider]
        static SettingsProvider Create() => new SettingsProvider("Project/FastPoints", SettingsScope.Project,
            new[] { "point cloud", "lidar", "las", "laz", "octree", "sampler", "memory", "threads", "vram" })
        {
            guiHandler = _ => Draw(FastPointsSettings.instance),
        };

        static void Draw(FastPointsSettings settings)
        {
            if (s_problem != null)
                EditorGUILayout.HelpBox(s_problem, MessageType.Error);
            EditorGUI.BeginChangeCheck();
            settings.ConvertAtOnce = EditorGUILayout.Toggle("Convert what is imported", settings.ConvertAtOnce);
            if (settings.ConvertAtOnce)
                settings.ConvertOctrees = EditorGUILayout.Toggle("COPC, Potree and EPT, too", settings.ConvertOctrees);
            settings.Sampler = (Sampler)EditorGUILayout.EnumPopup("Sampler", settings.Sampler);
            settings.MemoryMiB = EditorGUILayout.IntSlider("Memory of a conversion (MiB)", settings.MemoryMiB, 64, 65536);
            settings.Workers = EditorGUILayout.IntSlider("Worker threads of a conversion (0: all)", settings.Workers, 0, 64);
            settings.UpdateMs = EditorGUILayout.IntSlider("Main thread of an update (ms)", settings.UpdateMs, 1, 30);
            settings.GpuMiB = EditorGUILayout.IntSlider("Graphics memory of points (MiB)", settings.GpuMiB, 64, 16384);
            settings.CopiedMiB = EditorGUILayout.IntSlider("Copied into Assets up to (MiB)", settings.CopiedMiB, 0, 2048);
            settings.PlayerVariants =
                (VariantChoice)EditorGUILayout.EnumPopup("Shader variants in players", settings.PlayerVariants);
            string place = EditorGUILayout.DelayedTextField("Converted clouds in", settings.Place);
            EditorGUILayout.HelpBox("A folder beside Assets, or anywhere else; clouds converted earlier stay where they are. " +
                "Graphics memory applies in the editor if a scene has no Point Cloud Settings, which begin with it when added; " +
                "in players that component decides, or 512 MiB.", MessageType.None);
            if (!EditorGUI.EndChangeCheck())
                return;
            s_problem = place == settings.Place ? null : PointCloudImports.Move(place);
            settings.Save();
        }
    }
}
