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
        public static bool Button(string text, params GUILayoutOption[] options) => false;
    }
}
