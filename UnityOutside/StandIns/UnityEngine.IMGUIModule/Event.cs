namespace UnityEngine;

public enum EventType
{
    MouseDown = 0,
    MouseUp = 1,
    MouseDrag = 3,
    KeyDown = 4,
    Repaint = 7,
    Layout = 8,
    DragUpdated = 9,
    DragPerform = 10,
    Used = 12,
}

public enum FocusType { Passive = 2 }

/// <summary>What a test says has happened.</summary>
public sealed class Event
{
    public static Event current { get; set; }
    public EventType type { get; set; }
    public int button { get; set; }
    public bool alt { get; set; }
    public KeyCode keyCode { get; set; }
    public Vector2 mousePosition { get; set; }

    public EventType GetTypeForControl(int controlID) => type;
    public void Use() => type = EventType.Used;
}

/// <summary>Leaves a window's code: whoever has called that takes it.</summary>
public sealed class ExitGUIException : Exception { }

public class GUI
{
    public static bool changed { get; set; }
}

public class GUIUtility
{
    internal static int LastControl;

    public static int hotControl { get; set; }
    public static string systemCopyBuffer { get; set; } = "";

    public static int GetControlID(FocusType focus) => ++LastControl;
    public static void ExitGUI() => throw new ExitGUIException();
}
