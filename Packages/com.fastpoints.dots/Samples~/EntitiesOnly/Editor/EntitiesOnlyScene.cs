using FastPoints.Editor;
using UnityEditor;

namespace FastPoints.Samples.EntitiesOnly
{
    /// <summary>Makes a scene with one object: entities are made in play mode.</summary>
    static class EntitiesOnlyScene
    {
        [MenuItem("FastPoints/Samples/Entities only")]
        static void Make() => SampleScene.Create(asset => SampleScene.Add<EntitiesOnlyStart>("Start").Cloud = asset);
    }
}
