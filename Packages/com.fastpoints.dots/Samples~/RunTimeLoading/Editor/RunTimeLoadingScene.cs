using FastPoints.Editor;
using UnityEditor;

namespace FastPoints.Samples.RunTimeLoading
{
    /// <summary>Makes a scene that refers to no cloud: the cloud is loaded in play mode, and in a player.</summary>
    static class RunTimeLoadingScene
    {
        [MenuItem("FastPoints/Samples/Run-time loading")]
        static void Make() => SampleScene.Create(_ => SampleScene.Add<LoadFromDisk>("Cloud from disk"));
    }
}
