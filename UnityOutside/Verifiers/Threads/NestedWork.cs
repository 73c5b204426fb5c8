namespace UnityOutside.Threads;

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

    internal bool IsStepped(MethodDefinition method, MethodReference called) =>
        method.DeclaringType.FullName == Stack && called.Name is "MoveNext" or "Dispose";
}
