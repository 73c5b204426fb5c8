using StandIns.Engine;

namespace UnityEngine;

/// <summary>Everything goes to standard error: standard output belongs to the command line's own results.</summary>
public partial class Debug
{
    internal static Action<LogType, string> s_sink;

    public static void Log(object message) => Write(LogType.Log, message);
    public static void LogWarning(object message) => Write(LogType.Warning, message);
    public static void LogError(object message) => Write(LogType.Error, message);

    public static void LogException(Exception exception)
    {
        LoggedExceptions.Add(exception);
        Write(LogType.Exception, exception);
    }

    static void Write(LogType type, object message)
    {
        string text = message?.ToString() ?? "Null";
        if (s_sink != null)
            s_sink(type, text);
        else
            Console.Error.WriteLine(text);
    }
}
