namespace UnityOutside.Threads;

/// <summary>Work that a package's coroutine keeps on a stack, where the way back to who made it is lost. It is followed from
/// where it is yielded, run to its end, or put on a stack by who steps it; and not from the stack.</summary>
/// <param name="Step">The type whose method Of makes a step of other work.</param>
/// <param name="Stack">The type that is made of work, and steps it with MoveNext.</param>
/// <param name="Coroutine">The type whose method RunToEnd does all of it.</param>
public sealed record NestedWork(string Step, string Stack, string Coroutine)
{
    /// <summary>Whether what a method gives as the first argument is work that is done on this thread.</summary>
    internal bool IsDone(MethodDefinition method, MethodReference called)
    {
        string type = called.DeclaringType.FullName;
        return (type == Step && called.Name == "Of") || (type == Coroutine && called.Name == "RunToEnd")
            || (type == Stack && called.Name == ".ctor" && method.Body.Instructions.Any(i =>
                i.Operand is MethodReference { Name: "MoveNext" } m && m.DeclaringType.FullName == Stack));
    }

    /// <summary>Whether a method steps or disposes what lies on the stack.</summary>
    internal bool IsStepped(MethodDefinition method, MethodReference called) =>
        method.DeclaringType.FullName == Stack && called.Name is "MoveNext" or "Dispose";
}
