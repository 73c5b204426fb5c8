using UnityEditor;
using UnityEngine;

namespace FastPoints.Projects.BuiltIn
{
    /// <summary>Has this project draw in linear colour. It names no pipeline: the Built-in one draws it.</summary>
    sealed class ProjectSetup : AssetPostprocessor
    {
        /// <summary>Also when the project is opened: before that, assets may not be touched.</summary>
        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets,
            string[] movedFromAssetPaths, bool didDomainReload)
        {
            if (PlayerSettings.colorSpace != ColorSpace.Linear)
                PlayerSettings.colorSpace = ColorSpace.Linear;
        }
    }
}
