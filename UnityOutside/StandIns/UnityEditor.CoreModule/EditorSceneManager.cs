using UnityEngine.SceneManagement;

namespace UnityEditor
{
    public class SceneAsset : UnityEngine.Object { }

    /// <summary>The eyes of the hierarchy; a child is hidden by its own, which closing a parent's closes, too.</summary>
    public class SceneVisibilityManager : ScriptableSingleton<SceneVisibilityManager>
    {
        readonly HashSet<GameObject> m_hidden = new HashSet<GameObject>();

        public static event Action visibilityChanged;
        internal readonly HashSet<GameObject> Unpickable = new HashSet<GameObject>();

        public bool IsPickingDisabled(GameObject gameObject, bool includeDescendants = false) => Unpickable.Contains(gameObject);

        public bool IsHidden(GameObject gameObject, bool includeDescendants = false) => m_hidden.Contains(gameObject);

        internal void Set(GameObject gameObject, bool isHidden)
        {
            if (isHidden ? m_hidden.Add(gameObject) : m_hidden.Remove(gameObject))
                visibilityChanged?.Invoke();
        }
    }
}

namespace UnityEditor.SceneManagement
{
    public static class SceneCullingMasks
    {
        public const ulong GameViewObjects = 1UL << 63;
        public const ulong MainStageSceneViewObjects = 3UL << 61;
    }

    public static class StageUtility
    {
        internal static Scene Focused;

        public static bool IsGameObjectRenderedByCameraAndPartOfEditableScene(GameObject gameObject, Camera camera) =>
            (gameObject.sceneCullingMask & (camera.overrideSceneCullingMask != 0 ? camera.overrideSceneCullingMask
                : camera.scene.IsValid() ? camera.scene.Mask : ulong.MaxValue)) != 0 &&
            (!Focused.IsValid() || gameObject.scene == Focused);
    }

    public enum NewSceneSetup { EmptyScene = 0, DefaultGameObjects = 1 }

    public enum NewSceneMode { Single = 0, Additive = 1 }

    /// <summary>There is one scene; a new one brings its camera.</summary>
    public sealed class EditorSceneManager : SceneManager
    {
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

        public static ulong GetSceneCullingMask(Scene scene) => scene.Mask;

        static void CheckIsEditing()
        {
            if (Application.isPlaying)
                throw new InvalidOperationException("This cannot be used during play mode.");
        }

        /// <summary>Its objects stay where they are; there is a file of that name.</summary>
        public static bool SaveScene(Scene scene, string dstScenePath)
        {
            File.WriteAllText(dstScenePath, "");
            return true;
        }
    }
}
