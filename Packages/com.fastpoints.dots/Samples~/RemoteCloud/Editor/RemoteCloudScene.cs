using FastPoints.Editor;
using UnityEditor;

namespace FastPoints.Samples.RemoteCloud
{
    /// <summary>Makes a scene whose cloud is named in play mode, or in the inspector.</summary>
    static class RemoteCloudScene
    {
        [MenuItem("FastPoints/Samples/Remote cloud")]
        static void Make() => SampleScene.Create(_ => SampleScene.Add<OpenAddress>("Remote cloud"));
    }
}
