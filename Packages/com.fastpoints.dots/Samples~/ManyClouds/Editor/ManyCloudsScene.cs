using FastPoints.Editor;
using UnityEditor;

namespace FastPoints.Samples.ManyClouds
{
    /// <summary>Makes a scene with 64 streets, which are made in play mode.</summary>
    static class ManyCloudsScene
    {
        [MenuItem("FastPoints/Samples/Many clouds")]
        static void Make() => SampleScene.Create(asset => SampleScene.Add<CloudGrid>("Grid of clouds").Cloud = asset);
    }
}
