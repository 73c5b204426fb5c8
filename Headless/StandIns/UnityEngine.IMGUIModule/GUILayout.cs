namespace UnityEngine;

public class GUIContent
{
    public GUIContent(string text, string tooltip) { }
}

public sealed class GUILayoutOption
{
    internal GUILayoutOption() { }
}

/// <summary>Places are given at the Layout event; who asks for more of them at the Repaint is thrown out.</summary>
public class GUILayoutUtility
{
    static int s_places;
    static int s_taken;

    /// <summary>One control.</summary>
    internal static void Next()
    {
        if (Event.current == null)
            return;
        s_taken++;
        if (Event.current.type == EventType.Layout)
            s_places = s_taken;
        else if (Event.current.type == EventType.Repaint && s_taken > s_places)
            throw new ArgumentException("Getting control " + (s_taken - 1) + "'s position in a group with only " + s_places +
                " controls when doing " + Event.current.type + "\nAborting");
    }

    /// <summary>A window's picture: both of its events.</summary>
    internal static void Repaint(Action draw)
    {
        Send(new Event { type = EventType.Layout }, draw);
        Send(new Event { type = EventType.Repaint }, draw);
    }

    internal static void Send(Event sent, Action draw)
    {
        Event.current = sent;
        s_taken = 0;
        if (sent.type == EventType.Layout)
            s_places = 0;
        draw();
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
        return value;
    }

    public static bool Button(string text, params GUILayoutOption[] options)
    {
        GUILayoutUtility.Next();
        return text == Pressed;
    }

    public static void BeginHorizontal(params GUILayoutOption[] options) => GUILayoutUtility.Next();
    public static void EndHorizontal() { }
    public static void BeginArea(Rect screenRect) { }
    public static void EndArea() { }
}
