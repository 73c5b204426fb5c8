namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class)]
public class InitializeOnLoadAttribute : Attribute { }

public sealed class EditorApplication
{
    public delegate void CallbackFunction();

    public static CallbackFunction update;

    /// <summary>Called once, at the next update: a host says when.</summary>
    public static CallbackFunction delayCall;

    internal static int s_queuedUpdates;

    /// <summary>Play mode begins and ends at once: scripts are not loaded anew.</summary>
    public static bool isPlaying
    {
        get => SceneLoop.IsPlaying;
        set => SceneLoop.IsPlaying = value;
    }

    /// <summary>Also while it begins and ends, which takes no time here.</summary>
    public static bool isPlayingOrWillChangePlaymode => isPlaying;

    /// <summary>No frame comes while it is true, as a test says.</summary>
    public static bool isPaused { get; internal set; }

    public static event Action quitting;

    /// <summary>As a test says.</summary>
    public static bool isFocused { get; internal set; } = true;

    static int s_takenUpdates;

    /// <summary>However often it was asked for: one frame.</summary>
    public static void QueuePlayerLoopUpdate() => s_queuedUpdates++;

    internal static bool TakeUpdate()
    {
        bool isQueued = s_takenUpdates != s_queuedUpdates;
        s_takenUpdates = s_queuedUpdates;
        return isQueued;
    }

    internal static void CallDelayed()
    {
        var delayed = delayCall;
        delayCall = null;
        delayed?.Invoke();
    }

    internal static void Quit() => quitting?.Invoke();
}

public static class AssemblyReloadEvents
{
    public delegate void AssemblyReloadCallback();

    public static event AssemblyReloadCallback beforeAssemblyReload;

    internal static bool IsHeardBy(object target) =>
        beforeAssemblyReload != null && Array.Exists(beforeAssemblyReload.GetInvocationList(), d => d.Target == target);

    internal static void Reload()
    {
        // Which of the two comes first is said nowhere: this order is the harder one.
        Progress.CancelManaged();
        beforeAssemblyReload?.Invoke();
    }
}
