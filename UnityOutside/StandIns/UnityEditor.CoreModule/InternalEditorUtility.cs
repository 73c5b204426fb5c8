using UnityEditor;

namespace UnityEditorInternal;

public sealed class InternalEditorUtility
{
    public static void RepaintAllViews() => SceneView.RepaintAll();
}
