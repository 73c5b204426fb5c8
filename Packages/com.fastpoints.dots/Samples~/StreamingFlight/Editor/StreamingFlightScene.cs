using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.StreamingFlight
{
    /// <summary>Makes a scene whose camera flies through the street in play mode.</summary>
    static class StreamingFlightScene
    {
        [MenuItem("FastPoints/Samples/Streaming flight")]
        static void Make() => SampleScene.Create(asset =>
        {
            var cloud = PointCloudDrops.AddToScene(asset, Vector3.zero, null);
            var camera = Camera.main.gameObject;
            ObjectFactory.AddComponent<FlyThrough>(camera).Cloud = cloud;
            ObjectFactory.AddComponent<FrameFigures>(camera);
        });
    }
}
