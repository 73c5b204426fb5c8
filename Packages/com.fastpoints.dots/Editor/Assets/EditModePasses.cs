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
            if (!AssetDatabase.IsAssetImportWorkerProcess())
                Begin();
        }

        public static void Begin()
        {
            foreach (var begin in TypeCache.GetMethodsWithAttribute<BeginsPassAttribute>())
                begin.Invoke(null, null);
        }
    }
}
