namespace FastPoints.RepoTools.Threads;

/// <summary>Work that the package's pump keeps on a stack, where the way back to who made it is lost. It is followed from where
/// it is yielded, run to its end, or put on a stack by who steps it; and not from the stack.</summary>
internal static class NestedWork
{
    private const string Step = "FastPoints.Core.Work";
    private const string Stack = "FastPoints.Core.WorkSteps";
    private const string Pump = "FastPoints.Core.WorkPump";

    /// <summary>Whether what a method gives as the first argument is work that is done on this thread.</summary>
    internal static bool IsDone(MethodDefinition method, MethodReference called) =>
        (called.DeclaringType.FullName, called.Name) switch
        {
            (Step, "Of") or (Pump, "RunToEnd") => true,
            (Stack, ".ctor") => method.Body.Instructions.Any(i => i.Operand is MethodReference { Name: "MoveNext" } m &&
                m.DeclaringType.FullName == Stack),
            _ => false,
        };

    /// <summary>Whether a method steps or disposes what lies on the stack.</summary>
    internal static bool IsStepped(MethodDefinition method, MethodReference called) =>
        method.DeclaringType.FullName == Stack && called.Name is "MoveNext" or "Dispose";
}
