namespace UnityEngine
{
    public sealed class GUILayoutOption
    {
        internal GUILayoutOption()
        {
        }
    }

    /// <summary>There is no window: nothing is ever pressed.</summary>
    public class GUILayout
    {
        public static void Label(string text, params GUILayoutOption[] options)
        {
        }

        public static bool Toggle(bool value, string text, params GUILayoutOption[] options) => value;

        public static bool Button(string text, params GUILayoutOption[] options) => false;

        public static void BeginArea(Rect screenRect)
        {
        }

        public static void EndArea()
        {
        }
    }
}
