namespace UnityOutside.Threads;

internal sealed class StackFlow
{
    private readonly MethodBody m_body;
    private readonly Dictionary<Instruction, HashSet<Instruction>[]> m_before =
        new Dictionary<Instruction, HashSet<Instruction>[]>();

    internal StackFlow(MethodBody body)
    {
        m_body = body;
        Run();
    }

    internal static IEnumerable<Instruction> Next(Instruction at)
    {
        if (at.Operand is Instruction target && at.OpCode.FlowControl is FlowControl.Branch or FlowControl.Cond_Branch)
            yield return (Instruction)at.Operand;
        if (at.Operand is Instruction[] targets)
        {
            foreach (Instruction each in targets)
                yield return each;
        }
        bool ends = at.OpCode.FlowControl is FlowControl.Branch or FlowControl.Return or FlowControl.Throw;
        if (!ends && at.Next != null)
            yield return at.Next;
    }

    internal static int ArgumentCount(Instruction call)
    {
        var method = (IMethodSignature)call.Operand;
        bool takesObject = method.HasThis && !method.ExplicitThis && call.OpCode.Code != Code.Newobj;
        return method.Parameters.Count + (takesObject ? 1 : 0);
    }

    /// <summary>Who pushed a value that an instruction takes; 0 is the top of the stack.</summary>
    internal IReadOnlyCollection<Instruction> Producers(Instruction user, int fromTop)
    {
        // What no way leads to has no stack.
        if (!m_before.TryGetValue(user, out HashSet<Instruction>[]? stack) || fromTop >= stack.Length)
            return Array.Empty<Instruction>();
        return stack[stack.Length - 1 - fromTop];
    }

    /// <summary>Who pushed an argument of a call; 0 is the object, where it has one.</summary>
    internal IReadOnlyCollection<Instruction> Argument(Instruction call, int index) =>
        Producers(call, ArgumentCount(call) - 1 - index);

    private void Run()
    {
        var open = new Queue<Instruction>();
        Enter(m_body.Instructions[0], Array.Empty<HashSet<Instruction>>(), open);
        foreach (ExceptionHandler handler in m_body.ExceptionHandlers)
        {
            bool hasException = handler.HandlerType is ExceptionHandlerType.Catch or ExceptionHandlerType.Filter;
            Enter(handler.HandlerStart, hasException ? One(handler.HandlerStart) : Array.Empty<HashSet<Instruction>>(), open);
            if (handler.FilterStart != null)
                Enter(handler.FilterStart, One(handler.FilterStart), open);
        }
        while (open.TryDequeue(out Instruction? at))
        {
            HashSet<Instruction>[] after = After(at, m_before[at]);
            foreach (Instruction next in Next(at))
                Enter(next, after, open);
        }
    }

    private static HashSet<Instruction>[] One(Instruction at) => new[] { new HashSet<Instruction> { at } };

    private void Enter(Instruction at, HashSet<Instruction>[] stack, Queue<Instruction> open)
    {
        if (!m_before.TryGetValue(at, out HashSet<Instruction>[]? known))
        {
            m_before.Add(at, stack);
            open.Enqueue(at);
            return;
        }
        HashSet<Instruction>[]? joined = null;
        for (int i = 0; i < Math.Min(known.Length, stack.Length); i++)
        {
            if (ReferenceEquals(known[i], stack[i]) || stack[i].IsSubsetOf(known[i]))
                continue;
            joined ??= (HashSet<Instruction>[])known.Clone();
            joined[i] = new HashSet<Instruction>(known[i].Concat(stack[i]));
        }
        if (joined == null)
            return;
        m_before[at] = joined;
        open.Enqueue(at);
    }

    private HashSet<Instruction>[] After(Instruction at, HashSet<Instruction>[] stack)
    {
        if (at.OpCode.Code is Code.Leave or Code.Leave_S)
            return Array.Empty<HashSet<Instruction>>();
        if (at.OpCode.Code == Code.Dup)
            return stack.Append(stack[^1]).ToArray();
        int pops = Math.Min(PopCount(at, stack.Length), stack.Length);
        int pushes = PushCount(at);
        if (pops == 0 && pushes == 0)
            return stack;
        return stack.Take(stack.Length - pops).Concat(Enumerable.Range(0, pushes).Select(_ => One(at)[0])).ToArray();
    }

    private int PopCount(Instruction at, int depth)
    {
        switch (at.OpCode.StackBehaviourPop)
        {
            case StackBehaviour.Pop0:
                return 0;
            case StackBehaviour.Pop1 or StackBehaviour.Popi or StackBehaviour.Popref:
                return 1;
            case StackBehaviour.Pop1_pop1 or StackBehaviour.Popi_pop1 or StackBehaviour.Popi_popi or StackBehaviour.Popi_popi8
                or StackBehaviour.Popi_popr4 or StackBehaviour.Popi_popr8 or StackBehaviour.Popref_pop1
                or StackBehaviour.Popref_popi:
                return 2;
            case StackBehaviour.PopAll:
                return depth;
            case StackBehaviour.Varpop when at.OpCode.Code == Code.Ret:
                return IsVoid(m_body.Method.ReturnType) ? 0 : 1;
            case StackBehaviour.Varpop:
                return ArgumentCount(at) + (at.OpCode.Code == Code.Calli ? 1 : 0);
            default:
                return 3;
        }
    }

    private static int PushCount(Instruction at) => at.OpCode.StackBehaviourPush switch
    {
        StackBehaviour.Push0 => 0,
        StackBehaviour.Varpush => IsVoid(((IMethodSignature)at.Operand).ReturnType) ? 0 : 1,
        _ => 1,
    };

    private static bool IsVoid(TypeReference type) =>
        (type is IModifierType modifier ? modifier.ElementType : type).MetadataType == MetadataType.Void;
}
