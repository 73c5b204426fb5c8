using FastPoints.Editor;
using FastPoints.Surface;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.WalkOnAScan
{
    /// <summary>Makes a scene with the street and somebody who walks on it in play mode.</summary>
    static class WalkOnAScanScene
    {
        [MenuItem("FastPoints/Samples/Walk on a scan")]
        static void Make() => SampleScene.Create(asset =>
        {
            var cloud = PointCloudDrops.AddToScene(asset, Vector3.zero, null);
            var ground = ObjectFactory.AddComponent<PointCloudCollider>(cloud.gameObject);
            // The sample has a point on half a metre, and trees are no obstacle.
            (ground.VoxelSize, ground.HoleSize, ground.Radius) = (0.5f, 3, 20);
            ground.HiddenClasses = new[] { 5 };
            var walker = GameObject.CreatePrimitive(PrimitiveType.Capsule);
            walker.transform.position = new Vector3(-60, 3, -10);
            ObjectFactory.AddComponent<Walker>(walker).Ground = ground;
            ground.Followed.Add(walker.transform);
            Camera.main.transform.SetParent(walker.transform, true);
        });
    }
}
