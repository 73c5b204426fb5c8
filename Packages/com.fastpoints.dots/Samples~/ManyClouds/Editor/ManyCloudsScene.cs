using FastPoints.Editor;
using UnityEditor;

namespace FastPoints.Samples.ManyClouds
{
    /// <summary>64 streets, made in play mode.</summary>
    static class ManyCloudsScene
    {
        [MenuItem("FastPoints/Samples/Many clouds")]
        static void Make() => SampleScene.Make(asset => SampleScene.Add<CloudGrid>("Grid of clouds").Cloud = asset);
    }
}
