using FastPoints.Drawing;
using FastPoints.Editor;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Samples.AttributeColours
{
    /// <summary>Makes a scene with the street coloured by classes, and a box to look into.</summary>
    static class AttributeColoursScene
    {
        [MenuItem("FastPoints/Samples/Attribute colours")]
        static void Make() => SampleScene.Create(asset =>
        {
            var cloud = PointCloudDrops.AddToScene(asset, Vector3.zero, null);
            cloud.Color = ColorMode.Classification;
            ObjectFactory.AddComponent<ColourSwitch>(cloud.gameObject);
            var box = SampleScene.Add<FastPoints.Entities.PointCloudClipBox>("Clip box").transform;
            box.position = new Vector3(-20, 10, -11);
            box.localScale = new Vector3(80, 40, 60);
        });
    }
}
