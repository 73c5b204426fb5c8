using StandIns.Scene;
using UnityEngine.SceneManagement;

namespace UnityEditor
{
    public class SceneAsset : UnityEngine.Object { }
}

namespace UnityEditor.SceneManagement
{
    public enum NewSceneSetup { EmptyScene = 0, DefaultGameObjects = 1 }

    public enum NewSceneMode { Single = 0, Additive = 1 }

    /// <summary>There is one scene, and previews of others; a new one brings its camera.</summary>
    public sealed class EditorSceneManager : SceneManager
    {
        /// <summary>What the user answers when asked to save.</summary>
        internal static bool s_goesOn = true;

        public static bool SaveCurrentModifiedScenesIfUserWantsTo()
        {
            CheckIsEditing();
            return s_goesOn;
        }

        public static Scene NewScene(NewSceneSetup setup, NewSceneMode mode)
        {
            CheckIsEditing();
            if (mode == NewSceneMode.Single)
                SceneLoop.Clear();
            if (setup == NewSceneSetup.DefaultGameObjects)
                Camera.main = new GameObject("Main Camera").AddComponent<Camera>();
            return default;
        }

        static void CheckIsEditing()
        {
            if (Application.isPlaying)
                throw new InvalidOperationException("This cannot be used during play mode.");
        }

        /// <summary>Roots of scenes by path, as a test puts them there.</summary>
        internal static readonly Dictionary<string, GameObject[]> Scenes = new Dictionary<string, GameObject[]>();

        /// <summary>Paths of those that were opened.</summary>
        internal static readonly List<string> Opened = new List<string>();

        internal static int s_previewScenes;

        public static Scene OpenPreviewScene(string scenePath)
        {
            s_previewScenes++;
            Opened.Add(scenePath);
            return new Scene { Roots = Scenes[scenePath], Path = scenePath };
        }

        public static bool ClosePreviewScene(Scene scene)
        {
            s_previewScenes--;
            return true;
        }

        public static bool SaveScene(Scene scene, string dstScenePath) => throw EditorOnly.NotHere(nameof(SaveScene));
    }
}
