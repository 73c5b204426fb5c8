using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor
{
    public class SceneAsset : UnityEngine.Object
    {
    }
}

namespace UnityEditor.SceneManagement
{
    public enum NewSceneSetup
    {
        EmptyScene = 0,
        DefaultGameObjects = 1,
    }

    public enum NewSceneMode
    {
        Single = 0,
        Additive = 1,
    }

    /// <summary>There is one scene; a new one brings its camera.</summary>
    public sealed class EditorSceneManager : SceneManager
    {
        /// <summary>What the user answers when asked to save.</summary>
        internal static bool s_goesOn = true;

        public static bool SaveCurrentModifiedScenesIfUserWantsTo() => s_goesOn;

        public static Scene NewScene(NewSceneSetup setup, NewSceneMode mode)
        {
            if (setup == NewSceneSetup.DefaultGameObjects)
                Camera.main = new GameObject("Main Camera").AddComponent<Camera>();
            return default;
        }

        public static bool SaveScene(Scene scene, string dstScenePath) => throw EditorOnly.NotHere(nameof(SaveScene));
    }
}
