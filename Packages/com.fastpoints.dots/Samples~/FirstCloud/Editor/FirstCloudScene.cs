using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.FirstCloud
{
    /// <summary>Makes a scene with a cloud, a camera and a mesh, as dropping a file into a scene does in any render
    /// pipeline.</summary>
    static class FirstCloudScene
    {
        [MenuItem("FastPoints/Samples/First cloud")]
        static void Make() => SampleScene.Create(asset =>
        {
            PointCloudDrops.AddToScene(asset, Vector3.zero, null);
            // Points and meshes hide each other because they share the camera's depth.
            var cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.transform.position = new Vector3(-52, 2.5f, -9);
            cube.transform.localScale = new Vector3(2, 2, 2);
        });
    }
}
