namespace UnityEngine;

public class GUIContent
{
    public GUIContent(string text, string tooltip) { }
}

public sealed class GUILayoutOption
{
    internal GUILayoutOption() { }
}

/// <summary>Places are given at the Layout event, in groups; who asks for more of them at the Repaint is thrown out. Who opens a
/// panel has other windows drawn meanwhile, with groups of theirs: nothing can be laid out after it in the same event.</summary>
public class GUILayoutUtility
{
    sealed class Group
    {
        public readonly List<Group> Entries = new List<Group>(); // Null for a control.

        public int Taken;
    }

    static readonly Stack<Group> s_groups = new Stack<Group>();
    static Group s_root = new Group();
    static bool s_isSent;
    static string s_panel;

    internal static void Next()
    {
        if (Event.current != null && Event.current.type != EventType.Used)
            Take(false);
    }

    internal static void Begin()
    {
        if (Event.current == null)
            return;
        var group = Take(true) ?? throw new ExitGUIException();
        group.Taken = 0;
        s_groups.Push(group);
    }

    internal static void End()
    {
        if (Event.current == null)
            return;
        CheckPanel();
        if (s_groups.Count == 0)
            throw new InvalidOperationException("EndLayoutGroup: BeginLayoutGroup must be called first.");
        s_groups.Pop();
    }

    internal static void Open(string panel) => s_panel = s_isSent ? panel : null;

    internal static void Repaint(Action draw)
    {
        Send(new Event { type = EventType.Layout }, draw);
        Send(new Event { type = EventType.Repaint }, draw);
    }

    internal static void Send(Event sent, Action draw)
    {
        Event.current = sent;
        s_root = sent.type == EventType.Layout ? new Group() : s_root;
        s_root.Taken = 0;
        s_groups.Clear();
        (s_isSent, s_panel) = (true, null);
        try
        {
            draw();
            if (s_groups.Count > 0)
                throw new InvalidOperationException("Invalid GUILayout state. Verify that all layout Begin/End calls match");
        }
        catch (Exception e) when (e is ExitGUIException || e.InnerException is ExitGUIException)
        {
            // The window is drawn by the next event.
        }
        finally
        {
            s_isSent = false;
        }
    }

    static Group Take(bool isGroup)
    {
        CheckPanel();
        var within = s_groups.Count > 0 ? s_groups.Peek() : s_root;
        if (Event.current.type == EventType.Layout || Event.current.type == EventType.Used)
        {
            within.Entries.Add(isGroup ? new Group() : null);
            return within.Entries[within.Entries.Count - 1];
        }
        if (within.Taken < within.Entries.Count)
            return within.Entries[within.Taken++];
        if (Event.current.type == EventType.Repaint)
            throw new ArgumentException("Getting control " + within.Taken + "'s position in a group with only " +
                within.Entries.Count + " controls when doing " + Event.current.type + "\nAborting");
        return null;
    }

    static void CheckPanel()
    {
        if (s_isSent && s_panel != null)
            throw new InvalidOperationException("EndLayoutGroup: BeginLayoutGroup must be called first. " + s_panel +
                " was open, and other windows were drawn: GUIUtility.ExitGUI() comes after it.");
    }
}

/// <summary>There is no window: nothing is pressed, unless a test presses the button of a name.</summary>
public class GUILayout
{
    internal static string Pressed;

    public static void Label(string text, params GUILayoutOption[] options) => GUILayoutUtility.Next();

    public static bool Toggle(bool value, string text, params GUILayoutOption[] options)
    {
        GUILayoutUtility.Next();
        return value != (text == Pressed);
    }

    public static bool Button(string text, params GUILayoutOption[] options)
    {
        GUILayoutUtility.Next();
        return text == Pressed;
    }

    public static string TextField(string text, params GUILayoutOption[] options)
    {
        GUILayoutUtility.Next();
        return text;
    }

    public static void BeginHorizontal(params GUILayoutOption[] options) => GUILayoutUtility.Begin();
    public static void EndHorizontal() => GUILayoutUtility.End();
    public static void BeginArea(Rect screenRect) { }
    public static void EndArea() { }
}
