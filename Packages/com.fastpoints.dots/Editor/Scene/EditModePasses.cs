using FastPoints.Rendering;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>Draws clouds in edit mode too, in all installed pipelines: their assemblies are found by the attribute
    /// alone.</summary>
    [InitializeOnLoad]
    internal static class EditModePasses
    {
        static EditModePasses()
        {
            if (AssetDatabase.IsAssetImportWorkerProcess())
                return;
            Begin();
            // Scene views keep their cameras, and these their command buffers, whose memory is freed.
            AssemblyReloadEvents.beforeAssemblyReload += End;
        }

        public static void Begin()
        {
            foreach (var begin in TypeCache.GetMethodsWithAttribute<BeginsPassAttribute>())
                begin.Invoke(null, null);
        }

        static void End()
        {
            foreach (var begin in TypeCache.GetMethodsWithAttribute<BeginsPassAttribute>())
                begin.DeclaringType.GetMethod("End").Invoke(null, null);
        }
    }
}
