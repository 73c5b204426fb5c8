namespace UnityEditor;

public class EditorWindow : ScriptableObject
{
    /// <summary>There is one of a kind.</summary>
    public static T GetWindow<T>(string title) where T : EditorWindow =>
        (T)(s_windows.TryGetValue(typeof(T), out var open) && open != null ? open : s_windows[typeof(T)] = CreateInstance<T>());

    static readonly Dictionary<Type, EditorWindow> s_windows = new Dictionary<Type, EditorWindow>();

    public void Repaint() { }
}

public class SearchableEditorWindow : EditorWindow { }

/// <summary>A host gives it its camera.</summary>
public class SceneView : SearchableEditorWindow
{
    internal static int Repaints;

    public Camera camera { get; internal set; }

    public static SceneView lastActiveSceneView { get; internal set; }

    /// <summary>What it turns about.</summary>
    public Vector3 pivot { get; set; }

    public static void RepaintAll() => Repaints++;
}

/// <summary>Nothing is drawn; a test says what the pointer points along.</summary>
public sealed class HandleUtility
{
    internal static Ray PointedAlong;

    public delegate GameObject PickGameObjectCallback(Camera cam, int layers, Vector2 position, GameObject[] ignore,
        GameObject[] filter, out int materialIndex);

    public static event PickGameObjectCallback pickGameObjectCustomPasses;

    /// <summary>What a click at a pixel goes through from front to back, in a scene without meshes. A pass is not trusted: what
    /// it should have ignored is not taken, and another material would be another object.</summary>
    internal static List<GameObject> Click(Camera camera, Vector2 position)
    {
        var hit = new List<GameObject>();
        var ignore = new List<GameObject>();
        while (PickedBy(camera, position, ignore, null) is { } picked)
        {
            // One that is not to be ignored would be found for ever.
            if (!SceneVisibilityManager.instance.IsPickingDisabled(picked))
                hit.Add(picked);
            ignore.Add(picked);
        }
        if (hit.Count > 0 && PickedBy(camera, position, null, new List<GameObject> { hit[0] }) != hit[0])
            throw new InvalidOperationException("clicking again would not find what is selected");
        return hit;
    }

    static GameObject PickedBy(Camera camera, Vector2 position, List<GameObject> ignore, List<GameObject> filter)
    {
        foreach (PickGameObjectCallback pass in pickGameObjectCustomPasses?.GetInvocationList() ?? new Delegate[0])
        {
            // Unity gives null for an empty list.
            var picked = pass(camera, camera.cullingMask, position, ignore?.Count > 0 ? ignore.ToArray() : null,
                filter?.Count > 0 ? filter.ToArray() : null, out int material);
            if (picked != null && material <= 0 && ignore?.Contains(picked) != true && filter?.Contains(picked) != false)
                return picked;
        }
        return null;
    }

    public static int nearestControl { get; set; }

    public static void AddDefaultControl(int controlId) => nearestControl = controlId;
    public static Ray GUIPointToWorldRay(Vector2 position) => PointedAlong;
    public static float GetHandleSize(Vector3 position) => 1;
}

public sealed class Tools
{
    /// <summary>Layers that the user has locked: a bit for each.</summary>
    public static int lockedLayers { get; internal set; }
}

public sealed class Handles
{
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void DrawLine(Vector3 p1, Vector3 p2) { }
    public static void DrawWireDisc(Vector3 center, Vector3 normal, float radius) { }
    public static void Label(Vector3 position, string text) { }
    public static void BeginGUI() { }
    public static void EndGUI() { }
}

/// <summary>What was made, and the fields of what was recorded.</summary>
public class Undo
{
    /// <summary>Those of one group are undone at once.</summary>
    static readonly Stack<(int Group, Action Step)> s_steps = new Stack<(int, Action)>();

    static int s_group;

    public delegate void UndoRedoCallback();

    public static UndoRedoCallback undoRedoPerformed;

    public static void PerformUndo()
    {
        if (s_steps.Count == 0)
            return;
        int group = s_steps.Peek().Group;
        while (s_steps.Count > 0 && s_steps.Peek().Group == group)
            s_steps.Pop().Step();
        undoRedoPerformed?.Invoke();
    }

    /// <summary>What Unity keeps of it comes back, past properties: no setter is called.</summary>
    public static void RecordObject(Object objectToUndo, string name)
    {
        if (objectToUndo is Transform transform)
        {
            var before = transform.localToWorldMatrix;
            Add(() => transform.localToWorldMatrix = before);
            return;
        }
        var kept = SerializedFields.Of(objectToUndo.GetType()).Where(f => SerializedFields.IsKept(f.FieldType))
            .Select(f => (Field: f, Before: f.GetValue(objectToUndo) is Array many ? many.Clone() : f.GetValue(objectToUndo)))
            .ToArray();
        Add(() =>
        {
            foreach (var (field, before) in kept)
                field.SetValue(objectToUndo, before);
        });
    }

    /// <summary>As a press of the mouse does, and a menu's item: what comes without is part of what was there last.</summary>
    public static void IncrementCurrentGroup() => s_group++;

    internal static void Add(Action step) => s_steps.Push((s_group, step));
    internal static void Clear() => s_steps.Clear();
}

public class EditorGUIUtility : GUIUtility
{
    public static float pixelsPerPoint => 1;
    public static float labelWidth { get; set; } = 150;
}
