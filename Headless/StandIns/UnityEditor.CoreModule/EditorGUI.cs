namespace UnityEditor;

public enum MessageType { None = 0, Info = 1, Warning = 2, Error = 3 }

/// <summary>There is no window: nothing is shown, and every value stays as it is.</summary>
public sealed class EditorGUI
{
    static int s_checks;

    public static void BeginChangeCheck() => s_checks++;

    public static bool EndChangeCheck() =>
        --s_checks < 0 ? throw new InvalidOperationException("EndChangeCheck without a BeginChangeCheck") : false;
}

/// <summary>Each control takes its place in the layout.</summary>
public sealed class EditorGUILayout
{
    public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) => Draw(property);
    public static void LabelField(string label, string label2, params GUILayoutOption[] options) => GUILayoutUtility.Next();
    public static void HelpBox(string message, MessageType type) => GUILayoutUtility.Next();

    public static int IntSlider(string label, int value, int leftValue, int rightValue,
        params GUILayoutOption[] options) => Placed(value);

    public static bool Toggle(string label, bool value, params GUILayoutOption[] options) => Placed(value);
    public static bool ToggleLeft(string label, bool value, params GUILayoutOption[] options) => Placed(value);
    public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick) => Placed(true);
    public static string DelayedTextField(string label, string text, params GUILayoutOption[] options) => Placed(text);
    public static Enum EnumPopup(string label, Enum selected, params GUILayoutOption[] options) => Placed(selected);

    internal static bool Draw(SerializedProperty property) =>
        property != null ? Placed(false) : throw new NullReferenceException("there is no such property");

    static T Placed<T>(T value)
    {
        GUILayoutUtility.Next();
        return value;
    }
}

public class EditorUtility
{
    public static bool DisplayDialog(string title, string message, string ok, string cancel) => false;
    public static string OpenFilePanelWithFilters(string title, string directory, string[] filters) => "";
    public static string OpenFolderPanel(string title, string folder, string defaultName) => "";
    public static void RevealInFinder(string path) { }
    public static void SetDirty(Object target) { }
}

/// <summary>Undo takes away what it makes.</summary>
public static class ObjectFactory
{
    public static GameObject CreateGameObject(string name, params Type[] types)
    {
        var made = new GameObject(name);
        Undo.Add(() => Object.DestroyImmediate(made));
        return made;
    }

    public static T AddComponent<T>(GameObject gameObject) where T : Component => gameObject.AddComponent<T>();
}

public sealed class Selection
{
    public static Object activeObject { get; set; }
}
