using System.Runtime.ExceptionServices;

namespace StandIns.Engine;

/// <summary>What was logged in place of being thrown: by jobs, by groups of systems, by whoever else. Unity goes on then;
/// here it is kept as well, so that a test or a command can fail for it, as a test does in Unity.</summary>
static class LoggedExceptions
{
    static readonly Queue<ExceptionDispatchInfo> s_exceptions = new Queue<ExceptionDispatchInfo>();

    internal static void Add(Exception exception)
    {
        lock (s_exceptions)
            s_exceptions.Enqueue(ExceptionDispatchInfo.Capture(exception));
    }

    /// <summary>Throws the first since the last call, and forgets the others; nothing if there is none.</summary>
    internal static void ThrowFirst()
    {
        ExceptionDispatchInfo first;
        lock (s_exceptions)
        {
            if (s_exceptions.Count == 0)
                return;
            first = s_exceptions.Dequeue();
            s_exceptions.Clear();
        }
        first.Throw();
    }
}
