namespace UnityOutside.Threads;

/// <summary>Code that begins on a thread that need not be the main one.</summary>
internal sealed record ThreadRoot(string Name, TypeDefinition Within, MethodReference? Method,
    Value? Self = null, bool IsJob = false, Instruction? From = null);

/// <summary>Finds them in the IL: delegates that are handed to what runs them elsewhere, jobs, finalizers, what follows
/// ConfigureAwait(false), and what Unity's serializer calls from its loading thread.</summary>
internal static class ThreadRoots
{
    internal static IEnumerable<ThreadRoot> Of(CodeIndex code, ValueOrigins origins)
    {
        foreach (MethodDefinition method in code.Methods)
        {
            foreach (Instruction at in method.Body.Instructions.Where(i => i.Operand is MethodReference))
            {
                foreach (ThreadRoot root in AtCall(code, origins, method, at))
                    yield return root;
            }
        }
        foreach (TypeDefinition type in code.Types)
        {
            foreach (ThreadRoot root in OfType(type))
                yield return root;
        }
    }

    /// <summary>The delegates that a call may be given: if it is unknown which, all of that type that are created
    /// anywhere.</summary>
    internal static IEnumerable<Value> Delegates(CodeIndex code, ValueOrigins origins, Site call, Value? self, int argument,
        TypeReference wanted)
    {
        foreach (Value value in origins.Argument(call.Method, self, call.At, argument))
        {
            if (value.Target != null)
            {
                yield return value;
                continue;
            }
            TypeReference type = TypeRelations.IsDelegate(value.Type) ? value.Type : wanted;
            foreach (Site made in code.Delegates)
            {
                var constructor = (MethodReference)made.At.Operand;
                Instruction? address = code.Flow(made.Method).Producers(made.At, 0).FirstOrDefault();
                if (address?.Operand is MethodReference target && TypeRelations.IsAssignable(constructor.DeclaringType, type))
                    yield return new Value(constructor.DeclaringType, made.Method, true, target);
            }
        }
    }

    private static IEnumerable<ThreadRoot> AtCall(CodeIndex code, ValueOrigins origins, MethodDefinition method, Instruction at)
    {
        var called = (MethodReference)at.Operand;
        string place = CodeLocation.Of(method, at);
        TypeDefinition within = method.DeclaringType;
        if (ThreadStarts.IsConfigureAwaitFalse(at))
            yield return new ThreadRoot($"after ConfigureAwait(false) ({place})", within, method, From: at);
        if (at.OpCode.Code is not (Code.Call or Code.Callvirt or Code.Newobj) || !ThreadStarts.IsStart(called))
            yield break;
        int first = StackFlow.ArgumentCount(at) - called.Parameters.Count;
        string name = $"{called.DeclaringType.Name.Split('`')[0]}.{called.Name.TrimStart('.')} ({place})";
        for (int i = 0; i < called.Parameters.Count; i++)
        {
            TypeReference type = called.Parameters[i].ParameterType;
            if (!TypeRelations.IsDelegate(type))
                continue;
            List<Value> targets = Delegates(code, origins, new Site(method, at), null, first + i, type).ToList();
            if (targets.Count == 0)
                yield return new ThreadRoot(name, within, null);
            foreach (Value target in targets)
                yield return new ThreadRoot(name, within, target.Target, target.Inner);
        }
    }

    private static IEnumerable<ThreadRoot> OfType(TypeDefinition type)
    {
        string name = DocId.DefinitionName(type);
        bool isJob = HpcEntries.IsJob(type);
        if (isJob)
        {
            foreach (MethodDefinition method in HpcEntries.OfJob(type))
                yield return new ThreadRoot("job " + name, type, method, IsJob: true);
        }
        // Unity makes them while it loads, with the constructor without parameters, on whatever thread does that.
        bool isLoaded = (type.IsSerializable && !type.Name.StartsWith('<'))
            || TypeRelations.AllOf(type).Any(t => t.FullName == "UnityEngine.Object");
        bool isCalledBack = type.Interfaces.Any(i => i.InterfaceType.FullName == "UnityEngine.ISerializationCallbackReceiver");
        foreach (MethodDefinition method in type.Methods.Where(m => m.HasBody))
        {
            if (method.Name == "Finalize" && method.IsVirtual && method.Parameters.Count == 0)
                yield return new ThreadRoot("finalizer of " + name, type, method);
            if (isLoaded && method.IsConstructor && !method.IsStatic && method.Parameters.Count == 0)
                yield return new ThreadRoot("constructor of " + name, type, method);
            bool isOfSerializer = isCalledBack && (method.Name.EndsWith("OnBeforeSerialize", StringComparison.Ordinal)
                || method.Name.EndsWith("OnAfterDeserialize", StringComparison.Ordinal));
            if (isOfSerializer)
                yield return new ThreadRoot("serialization of " + name, type, method);
        }
    }
}
