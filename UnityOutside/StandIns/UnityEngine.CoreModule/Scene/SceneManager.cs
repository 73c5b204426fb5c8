namespace UnityEngine.SceneManagement;

public struct Scene
{
    internal string Path;
    internal int Number;

    /// <summary>Empty for one that was never saved.</summary>
    public string path => Path ?? "";

    internal ulong Mask;

    /// <summary>Whether it is a subscene's that is open.</summary>
    public bool isSubScene { get; internal set; }

    /// <summary>Not of one that was closed.</summary>
    public bool IsValid() => (Number != 0 || Mask != 0 || Path != null) && !SceneManager.s_closed.Contains(Number);

#if UNITY_6000_3_OR_NEWER
    public SceneHandle handle => default;
#else
    public int handle => Number;
#endif

    public static bool operator ==(Scene lhs, Scene rhs) => lhs.Number == rhs.Number;
    public static bool operator !=(Scene lhs, Scene rhs) => lhs.Number != rhs.Number;
    public override bool Equals(object other) => other is Scene scene && scene == this;
    public override int GetHashCode() => Number;
}

#if UNITY_6000_3_OR_NEWER
public struct SceneHandle { }
#endif

public partial class SceneManager
{
    internal static Scene s_active;

    /// <summary>Numbers of those that a test has closed.</summary>
    internal static readonly HashSet<int> s_closed = new HashSet<int>();

    /// <summary>Those that a test has opened; without any there is the active one.</summary>
    internal static readonly List<Scene> s_open = new List<Scene>();

    public static int sceneCount => Math.Max(1, s_open.Count);

    public static Scene GetSceneAt(int index) => s_open.Count > 0 || index > 0 ? s_open[index] : s_active;
    public static Scene GetActiveScene() => s_active;

    public static void MoveGameObjectToScene(GameObject go, Scene scene)
    {
        if (!scene.IsValid())
            throw new ArgumentException("The scene is not valid.");
        if (go.transform.Parent is not null)
            throw new ArgumentException("Gameobject is not a root in a scene");
        go.Scene = scene;
    }
}
