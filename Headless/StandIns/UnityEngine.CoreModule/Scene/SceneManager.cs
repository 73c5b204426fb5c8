namespace UnityEngine.SceneManagement
{
    public struct Scene
    {
    }

    public class SceneManager
    {
    }
}
