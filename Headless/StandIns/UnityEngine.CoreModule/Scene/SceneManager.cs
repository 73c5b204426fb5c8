namespace UnityEngine.SceneManagement;

public struct Scene
{
    internal GameObject[] Roots;
    internal string Path;

    /// <summary>Empty for one that was never saved.</summary>
    public string path => Path ?? "";

    internal ulong Mask;

    public bool IsValid() => Mask != 0 || Path != null;

    public GameObject[] GetRootGameObjects() => Roots;
}

public class SceneManager
{
    internal static Scene s_active;

    public static Scene GetActiveScene() => s_active;
}
