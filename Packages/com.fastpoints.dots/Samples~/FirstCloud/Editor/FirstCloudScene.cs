using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.FirstCloud
{
    /// <summary>A cloud, a camera and a mesh: what dropping a file into the scene makes, whatever the render pipeline.</summary>
    static class FirstCloudScene
    {
        [MenuItem("FastPoints/Samples/First cloud")]
        static void Make() => SampleScene.Make(asset =>
        {
            PointCloudDrops.Show(asset, Vector3.zero, null);
            // Points hide meshes and meshes points: they share the camera's depth.
            var cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.transform.position = new Vector3(-52, 2.5f, -9);
            cube.transform.localScale = new Vector3(2, 2, 2);
        });
    }
}
