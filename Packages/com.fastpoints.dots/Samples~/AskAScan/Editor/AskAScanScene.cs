using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.AskAScan
{
    /// <summary>Makes a scene whose camera asks the street.</summary>
    static class AskAScanScene
    {
        [MenuItem("FastPoints/Samples/Ask a scan")]
        static void Make() => SampleScene.Create(asset =>
        {
            PointCloudDrops.AddToScene(asset, Vector3.zero, null);
            ObjectFactory.AddComponent<AskScan>(Camera.main.gameObject);
        });
    }
}
