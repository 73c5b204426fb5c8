namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class)]
public class CustomEditor : Attribute
{
    public CustomEditor(Type inspectedType) { }
    public CustomEditor(Type inspectedType, bool editorForChildClasses) { }
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class CanEditMultipleObjects : Attribute { }

public class Editor : ScriptableObject
{
    public Object target { get; set; }
    public Object[] targets => Targets ?? new[] { target };

    internal Object[] Targets;

    public SerializedObject serializedObject => m_serialized?.targetObject == target ? m_serialized
        : m_serialized = new SerializedObject(target);

    SerializedObject m_serialized;

    public virtual bool RequiresConstantRepaint() => false;
    public virtual Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height) => null;
    public virtual void OnInspectorGUI() { }

    public static void CreateCachedEditor(Object targetObject, Type editorType, ref Editor previousEditor)
    {
        if (previousEditor != null && previousEditor.target == targetObject)
            return;
        if (previousEditor != null)
            DestroyImmediate(previousEditor);
        previousEditor = Of<Editor>(targetObject);
    }

    internal static T Of<T>(Object target) where T : Editor, new()
    {
        var made = new T { target = target };
        SceneLoop.Send(made, "OnEnable");
        return made;
    }

    internal void Draw() => GUILayoutUtility.Repaint(OnInspectorGUI);

    protected static void DrawPropertiesExcluding(SerializedObject obj, params string[] propertyToExclude)
    {
        foreach (string property in propertyToExclude)
            EditorGUILayout.Draw(obj.FindProperty(property));
    }
}

/// <summary>Nobody changes anything but the code that draws.</summary>
public class SerializedObject(Object obj)
{
    readonly Object m_target = obj != null ? obj : throw new ArgumentException("Object at index 0 is null");
    readonly Dictionary<string, double> m_changed = new();

    internal Object targetObject => m_target;

    public void Update() => m_changed.Clear();

    internal double this[string field]
    {
        get => m_changed.TryGetValue(field, out double value) ? value : (double)FieldOf(field).GetValue(m_target);
        set => m_changed[field] = value;
    }

    System.Reflection.FieldInfo FieldOf(string name) => SerializedFields.Of(m_target.GetType()).Single(f => f.Name == name);
    internal static Action<Object> s_typed; // What somebody has typed: it changes the fields, past properties.

    public bool ApplyModifiedProperties()
    {
        foreach (var (field, value) in m_changed)
            FieldOf(field).SetValue(m_target, value);
        bool isChanged = m_changed.Count > 0 || s_typed != null;
        m_changed.Clear();
        s_typed?.Invoke(m_target);
        return isChanged;
    }

    /// <returns>Null where Unity keeps no such field.</returns>
    public SerializedProperty FindProperty(string propertyPath) => propertyPath == "m_Script" ||
        SerializedFields.Of(m_target.GetType()).Any(f => f.Name == propertyPath && SerializedFields.IsKept(f.FieldType))
            ? new SerializedProperty(this, propertyPath)
            : null;
}

/// <summary>Changes reach the object by ApplyModifiedProperties.</summary>
public class SerializedProperty
{
    readonly SerializedObject m_object;
    readonly string m_field;

    internal SerializedProperty(SerializedObject of, string field) => (m_object, m_field) = (of, field);

    public double doubleValue
    {
        get => m_object[m_field];
        set => m_object[m_field] = value;
    }
}

/// <summary>What a menu's item was chosen for: in the Hierarchy's own menu, the object under the pointer.</summary>
public sealed class MenuCommand(Object inContext)
{
    public Object context = inContext;
}

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class MenuItem : Attribute
{
    public string menuItem;
    public bool validate;
    public int priority;

    public MenuItem(string itemName) : this(itemName, false, 1000) { }

    public MenuItem(string itemName, bool isValidateFunction, int priority) =>
        (menuItem, validate, this.priority) = (itemName, isValidateFunction, priority);
}

[AttributeUsage(AttributeTargets.Class)]
public class FilePathAttribute : Attribute
{
    public enum Location { PreferencesFolder = 0, ProjectFolder = 1 }

    internal readonly string RelativePath;

    public FilePathAttribute(string relativePath, Location location)
    {
        RelativePath = location == Location.ProjectFolder ? relativePath : throw EditorOnly.NotHere(location.ToString());
    }
}

/// <summary>What <see cref="Save"/> has written is read when it is asked for first; what was not saved goes with the
/// session. An import worker has one of its own, which knows nothing of this one: importers may not ask.</summary>
public class ScriptableSingleton<T> : ScriptableObject where T : ScriptableObject
{
    static T s_instance;

    protected ScriptableSingleton()
    {
        if (s_instance != null)
            Debug.LogError("ScriptableSingleton already exists. Did you query the singleton in a constructor?");
        else
            s_instance = (object)this as T;
    }

    public static T instance
    {
        get
        {
            if (AssetDatabase.IsAssetImportWorkerProcess())
                throw new InvalidOperationException("an import worker sees no " + typeof(T).Name + " of the main process");
            if (s_instance != null)
                return s_instance;
            var made = Activator.CreateInstance<T>();
            // Not to be edited otherwise: Save is the user's.
            made.hideFlags = HideFlags.HideAndDontSave & ~HideFlags.NotEditable;
            if (FilePath != null && File.Exists(FilePath))
                SettingsFile.Read(FilePath, made);
            SceneLoop.Send(made, "OnEnable");
            return made;
        }
    }

    protected virtual void Save(bool saveAsText)
    {
        if (FilePath == null)
            Debug.LogWarning("Saving has no effect. Your class '" + GetType() + "' is missing the FilePathAttribute.");
        else
            SettingsFile.Write(FilePath, this);
    }

    static string FilePath => typeof(T).GetCustomAttribute<FilePathAttribute>() is { } file
        ? Path.Combine(Path.GetDirectoryName(Application.dataPath), file.RelativePath)
        : null;
}

/// <summary>The fields of an object that Unity keeps, a line each.</summary>
static class SettingsFile
{
    public static void Write(string path, Object of)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(path));
        AssetDatabase.CheckWritable(path);
        s_writes++;
        File.WriteAllLines(path, Fields(of).Select(f => f.Name + ": " + TextOf(f.GetValue(of))));
    }

    internal static int s_writes;

    public static void Read(string path, Object into)
    {
        var lines = File.ReadAllLines(path).Select(l => l.Split(new[] { ": " }, 2, StringSplitOptions.None))
            .ToDictionary(l => l[0], l => l[1]);
        foreach (var field in Fields(into))
            if (lines.TryGetValue(field.Name, out string text))
                field.SetValue(into, field.FieldType.IsEnum ? Enum.Parse(field.FieldType, text)
                    : field.FieldType == typeof(string[]) ? text.Split(',', StringSplitOptions.RemoveEmptyEntries)
                    : Convert.ChangeType(text, field.FieldType, CultureInfo.InvariantCulture));
    }

    static string TextOf(object value) => value is string[] texts ? string.Join(",", texts)
        : Convert.ToString(value, CultureInfo.InvariantCulture);

    static IEnumerable<FieldInfo> Fields(Object of) =>
        SerializedFields.Of(of.GetType()).Where(f => SerializedFields.IsKept(f.FieldType));
}

public enum SettingsScope { User = 0, Project = 1 }

[AttributeUsage(AttributeTargets.Method)]
public sealed class SettingsProviderAttribute : Attribute { }

public class SettingsProvider
{
    public SettingsProvider(string path, SettingsScope scopes, IEnumerable<string> keywords = null)
    {
        settingsPath = path;
        scope = scopes;
    }

    public string settingsPath { get; }
    public SettingsScope scope { get; }
    public Action<string> guiHandler { get; set; }
}
