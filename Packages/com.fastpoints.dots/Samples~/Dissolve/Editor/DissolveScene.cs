using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.Dissolve
{
    /// <summary>Makes a scene with a street that can blow away.</summary>
    static class DissolveScene
    {
        // GUID of the sample's Dissolve.shader, wherever the sample was imported.
        const string ShaderGuid = "5b7cc0063f00fe23b72492de3760da06";

        [MenuItem("FastPoints/Samples/Dissolve")]
        static void Make() => SampleScene.Create(asset =>
        {
            var cloud = PointCloudDrops.AddToScene(asset, Vector3.zero, null);
            ObjectFactory.AddComponent<DissolveCloud>(cloud.gameObject).Shader =
                AssetDatabase.LoadAssetAtPath<Shader>(AssetDatabase.GUIDToAssetPath(ShaderGuid));
        });
    }
}
