namespace UnityOutside.Threads;

/// <summary>.NET's and Unity's members that run a delegate on a thread that need not be the main one.</summary>
internal static class ThreadStarts
{
    private static readonly HashSet<string> s_types = new HashSet<string>
    {
        "System.Threading.Tasks.Task", "System.Threading.Tasks.Task`1", "System.Threading.Tasks.TaskFactory",
        "System.Threading.Tasks.TaskFactory`1", "System.Threading.Tasks.Parallel", "System.Linq.ParallelEnumerable",
        "System.Threading.Thread", "System.Threading.ThreadPool", "System.Threading.Timer", "System.Timers.Timer",
        "System.IO.FileSystemWatcher", "System.Diagnostics.Process",
        // Whoever cancels, or asks first, runs it.
        "System.Threading.CancellationToken", "System.Lazy`1", "System.Threading.ThreadLocal`1",
        "System.Runtime.CompilerServices.ConfiguredTaskAwaitable/ConfiguredTaskAwaiter",
        "System.Runtime.CompilerServices.ConfiguredTaskAwaitable`1/ConfiguredTaskAwaiter",
    };

    internal static bool IsStart(MethodReference called) => s_types.Contains(called.DeclaringType.GetElementType().FullName)
        || called.FullName.Contains("UnityEngine.Application::add_logMessageReceivedThreaded(", StringComparison.Ordinal)
        || (called.Name == "BeginInvoke" && TypeRelations.IsDelegate(called.DeclaringType));

    /// <summary>Whether what follows in an async method need not be on the thread that it began on.</summary>
    internal static bool IsConfigureAwaitFalse(Instruction at) =>
        at.Operand is MethodReference { Name: "ConfigureAwait" } called
        && called.DeclaringType.Namespace.StartsWith("System.Threading.Tasks", StringComparison.Ordinal)
        && at.Previous?.OpCode.Code == Code.Ldc_I4_0;

    internal static TypeReference? StateMachine(MethodReference called) =>
        called is GenericInstanceMethod { Name: "Start" } start
        && called.DeclaringType.Namespace == "System.Runtime.CompilerServices"
        && called.DeclaringType.Name.Contains("MethodBuilder", StringComparison.Ordinal) ? start.GenericArguments[0] : null;
}
