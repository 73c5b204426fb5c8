namespace UnityEngine.SceneManagement
{
    public struct Scene
    {
        internal GameObject[] Roots;

        public GameObject[] GetRootGameObjects() => Roots;
    }

    public class SceneManager
    {
    }
}
