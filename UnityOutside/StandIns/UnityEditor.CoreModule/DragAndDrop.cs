namespace UnityEditor;

public enum DragAndDropVisualMode { None = 0, Copy = 1, Link = 2, Generic = 4, Move = 16, Rejected = 32 }

[Flags]
public enum HierarchyDropFlags
{
    None = 0,
    DropUpon = 1,
    DropBetween = 2,
    DropAfterParent = 4,
    SearchActive = 8,
    DropAbove = 16,
}

/// <summary>Asks the handlers of a window, the last that was added first, until one takes the drop.</summary>
public class DragAndDrop
{
    /// <summary>By the window: project, Scene view and hierarchy have delegates of their own.</summary>
    internal static readonly List<Delegate> Handlers = new List<Delegate>();

    public delegate DragAndDropVisualMode ProjectBrowserDropHandler(int dragInstanceID, string dropUponPath, bool perform);

    public delegate DragAndDropVisualMode ProjectBrowserDropHandlerV2(EntityId dragEntityId, string dropUponPath, bool perform);

    public delegate DragAndDropVisualMode SceneDropHandler(Object dropUpon, Vector3 worldPosition, Vector2 viewportPosition,
        Transform parentForDraggedObjects, bool perform);

    public delegate DragAndDropVisualMode HierarchyDropHandler(int dropTargetInstanceID, HierarchyDropFlags dropMode,
        Transform parentForDraggedObjects, bool perform);

    public delegate DragAndDropVisualMode HierarchyDropHandlerV2(EntityId dropTargetEntityId, HierarchyDropFlags dropMode,
        Transform parentForDraggedObjects, bool perform);

    public static string[] paths { get; set; } = new string[0];
    public static Object[] objectReferences { get; set; } = new Object[0];

    public static void PrepareStartDrag() => (paths, objectReferences) = (new string[0], new Object[0]);
    public static void AcceptDrag() { }
    public static void AddDropHandler(ProjectBrowserDropHandler handler) => Add(handler);
    public static void AddDropHandler(SceneDropHandler handler) => Add(handler);
    public static void AddDropHandler(HierarchyDropHandler handler) => Add(handler);
    public static void AddDropHandlerV2(ProjectBrowserDropHandlerV2 handler) => Add(handler);
    public static void AddDropHandlerV2(SceneDropHandler handler) => Add(handler);
    public static void AddDropHandlerV2(HierarchyDropHandlerV2 handler) => Add(handler);

    /// <summary>None: Unity's own handler is asked next.</summary>
    internal static DragAndDropVisualMode Drop<T>(params object[] args) where T : Delegate
    {
        for (int i = Handlers.Count - 1; i >= 0; i--)
            if (Handlers[i] is T handler &&
                (DragAndDropVisualMode)handler.DynamicInvoke(args) is var mode and not DragAndDropVisualMode.None)
                return mode;
        return DragAndDropVisualMode.None;
    }

    static void Add(Delegate handler)
    {
        if (Handlers.Contains(handler))
            throw new Exception("Delegate already registered");
        Handlers.Add(handler);
    }
}
