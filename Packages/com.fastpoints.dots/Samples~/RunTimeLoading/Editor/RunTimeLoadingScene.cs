using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.RunTimeLoading
{
    /// <summary>Makes a scene that refers to no cloud: the cloud is loaded in play mode, and in a player.</summary>
    static class RunTimeLoadingScene
    {
        // GUID of the sample's street.laz.bytes, wherever the sample was imported.
        const string StreetGuid = "05f3c5e52a2f4fbdb97bf4b8344c4dc7";

        [MenuItem("FastPoints/Samples/Run-time loading")]
        static void Make() => SampleScene.Create(_ => SampleScene.Add<LoadFromDisk>("Cloud from disk").Street =
            AssetDatabase.LoadAssetAtPath<TextAsset>(AssetDatabase.GUIDToAssetPath(StreetGuid)));
    }
}
