using FastPoints.Rendering;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>Clouds are drawn in edit mode too, in whatever pipelines are installed: their assemblies are known by the
    /// attribute alone.</summary>
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
