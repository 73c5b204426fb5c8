namespace UnityEditor;

public enum MessageType { None = 0, Info = 1, Warning = 2, Error = 3 }

/// <summary>There is no window: nothing is shown, and every value stays as it is.</summary>
public sealed class EditorGUI
{
    static readonly Stack<bool> s_changed = new();

    public static void BeginChangeCheck()
    {
        s_changed.Push(GUI.changed);
        GUI.changed = false;
    }

    public static bool EndChangeCheck()
    {
        if (s_changed.Count == 0)
            throw new InvalidOperationException("EndChangeCheck without a BeginChangeCheck");
        bool hasChanged = GUI.changed;
        GUI.changed |= s_changed.Pop();
        return hasChanged;
    }
}

/// <summary>Each control takes its place in the layout.</summary>
public sealed class EditorGUILayout
{
    public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) => Draw(property);
    public static void LabelField(string label, string label2, params GUILayoutOption[] options) => GUILayoutUtility.Next();
    public static void HelpBox(string message, MessageType type) => GUILayoutUtility.Next();

    public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options)
    {
        GUILayoutUtility.Begin();
        return scrollPosition;
    }

    public static void EndScrollView() => GUILayoutUtility.End();

    public static int IntSlider(GUIContent label, int value, int leftValue, int rightValue,
        params GUILayoutOption[] options) => Placed(value);

    public static bool Toggle(GUIContent label, bool value, params GUILayoutOption[] options) => Placed(value);
    public static bool ToggleLeft(string label, bool value, params GUILayoutOption[] options) => Placed(value);
    public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick) => Placed(true);
    public static Object ObjectField(GUIContent label, Object obj, Type objType, bool allowSceneObjects,
        params GUILayoutOption[] options) => Placed(obj);

    public static Object ObjectField(string label, Object obj, Type objType, bool allowSceneObjects,
        params GUILayoutOption[] options) => Placed(obj);

    public static int IntField(string label, int value, params GUILayoutOption[] options) => Placed(value);
    public static float FloatField(string label, float value, params GUILayoutOption[] options) => Placed(value);
    public static Color ColorField(string label, Color value, params GUILayoutOption[] options) => Placed(value);
    public static string DelayedTextField(GUIContent label, string text, params GUILayoutOption[] options) => Placed(text);
    public static Enum EnumPopup(GUIContent label, Enum selected, params GUILayoutOption[] options) => Placed(selected);

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
    internal static bool s_agrees;
    internal static readonly List<string> s_dialogs = new List<string>();

    public static bool DisplayDialog(string title, string message, string ok, string cancel)
    {
        s_dialogs.Add(message);
        GUILayoutUtility.Open(title);
        return s_agrees;
    }

    internal static int s_answer = -1; // The answer of a test: 0, 1 for cancel, 2; -1 fails it, for nobody is to be asked.

    internal static int s_asked;

    public static int DisplayDialogComplex(string title, string message, string ok, string cancel, string alt)
    {
        s_asked++;
        GUILayoutUtility.Open(title);
        return s_answer >= 0 ? s_answer : throw new InvalidOperationException("nobody is to be asked: " + message);
    }

    internal static readonly Dictionary<int, Object> s_objects = new Dictionary<int, Object>();

    /// <returns>Null where the number is nobody's, as that of a scene.</returns>
    public static Object InstanceIDToObject(int instanceID) => s_objects.TryGetValue(instanceID, out var found) ? found : null;

    public static Object EntityIdToObject(EntityId entityId) => throw EditorOnly.NotHere(nameof(EntityIdToObject));

    public static string OpenFilePanelWithFilters(string title, string directory, string[] filters)
    {
        GUILayoutUtility.Open(title);
        return s_file;
    }

    internal static string s_file = "";
    internal static string s_folder = ""; // What a test chooses; empty for nothing.

    public static string OpenFolderPanel(string title, string folder, string defaultName)
    {
        GUILayoutUtility.Open(title);
        return s_folder;
    }

    public static void RevealInFinder(string path) { }

    /// <summary>What was said to have changed: anything else is not saved.</summary>
    internal static readonly List<Object> s_dirty = new List<Object>();

    public static void SetDirty(Object target) => s_dirty.Add(target);
}

public static class PrefabUtility
{
    /// <summary>What instances of prefabs have been asked to keep: other changes by scripts go with the next load.</summary>
    internal static readonly List<Object> s_recorded = new List<Object>();

    public static void RecordPrefabInstancePropertyModifications(Object targetObject) => s_recorded.Add(targetObject);
}

/// <summary>Undo takes away what it makes.</summary>
public static class ObjectFactory
{
    internal static Transform s_defaultParent; // The Hierarchy's; null for none.

    public static GameObject CreateGameObject(string name, params Type[] types)
    {
        var made = new GameObject(name);
        if (s_defaultParent != null)
            made.transform.SetParent(s_defaultParent, true);
        Undo.Add(() => Object.DestroyImmediate(made));
        return made;
    }

    internal static GameObject s_stage; // The content's root of the prefab that is open; null for none.

    /// <summary>Beneath the parent; without one in the stage that is open, where <see cref="CreateGameObject"/> leaves it in the
    /// active scene. It is selected.</summary>
    public static void PlaceGameObject(GameObject go, GameObject parent = null)
    {
        if ((parent ?? s_stage) is { } above)
            go.transform.SetParent(above.transform, false);
        Selection.activeObject = go;
    }

    public static T AddComponent<T>(GameObject gameObject) where T : Component => gameObject.AddComponent<T>();
}

public sealed class Selection
{
    static Object s_active;

    /// <summary>What was destroyed is not selected any more.</summary>
    public static Object activeObject
    {
        get => s_active == null ? null : s_active;
        set => s_active = value;
    }
}
