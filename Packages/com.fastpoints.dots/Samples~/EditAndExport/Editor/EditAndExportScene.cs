using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.EditAndExport
{
    /// <summary>Makes a scene whose street can be edited in play mode.</summary>
    static class EditAndExportScene
    {
        [MenuItem("FastPoints/Samples/Edit and export")]
        static void Make() => SampleScene.Create(asset =>
            ObjectFactory.AddComponent<EditScan>(PointCloudDrops.AddToScene(asset, Vector3.zero, null).gameObject));
    }
}
