using FastPoints.Editor;
using UnityEditor;

namespace FastPoints.Samples.RunTimeLoading
{
    /// <summary>A scene that refers to no cloud: it is loaded in play mode, and in a player.</summary>
    static class RunTimeLoadingScene
    {
        [MenuItem("FastPoints/Samples/Run-time loading")]
        static void Make() => SampleScene.Make(_ => SampleScene.Add<LoadFromDisk>("Cloud from disk"));
    }
}
