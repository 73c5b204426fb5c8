namespace UnityOutside.Hpc;

/// <summary>What one method comes to for one processor: "Is...Supported" is a constant there, so of each branch on it one way is
/// left. Burst judges each method by itself, whoever calls it and whether it is inlined or not; what is left may call no
/// intrinsic that the processor lacks (BC1200).</summary>
internal sealed class IntrinsicCode
{
    private readonly HpcTarget m_target;
    private readonly MethodBody m_body;
    private readonly Dictionary<Instruction, Flag[]> m_before = new Dictionary<Instruction, Flag[]>();
    private readonly Stack<Instruction> m_next = new Stack<Instruction>();
    private readonly HashSet<int> m_pointedAt;
    private readonly record struct Flag(bool? Value, string? Asked, bool IsOpposite);

    private IntrinsicCode(MethodBody body, HpcTarget target)
    {
        (m_body, m_target) = (body, target);
        m_pointedAt = body.Instructions.Where(i => i.OpCode.Code is Code.Ldloca or Code.Ldloca_S)
            .Select(i => ((VariableDefinition)i.Operand).Index).ToHashSet();
    }

    /// <summary>What Burst refuses of a method, for which processors, and where.</summary>
    internal static IEnumerable<(Instruction At, string Reason)> Objections(MethodBody body)
    {
        if (!body.Instructions.Any(i => i.Operand is MethodReference m && (HpcTarget.Needed(m) ?? HpcTarget.Asked(m)) != null))
            return Enumerable.Empty<(Instruction, string)>();
        var refused = new Dictionary<(Instruction At, string Reason), string>();
        foreach (HpcTarget target in HpcTarget.All)
        {
            foreach ((Instruction at, string reason) in new IntrinsicCode(body, target).Run())
            {
                refused[(at, reason)] = refused.TryGetValue((at, reason), out string? others)
                    ? $"{others}, {target.Name}" : target.Name;
            }
        }
        return refused.Select(r => (r.Key.At, $"{r.Key.Reason} (for {r.Value})"));
    }

    private IEnumerable<(Instruction At, string Reason)> Run()
    {
        int locals = m_body.Variables.Count;
        Reach(m_body.Instructions[0], new Flag[locals]);
        foreach (ExceptionHandler handler in m_body.ExceptionHandlers)
            Reach(handler.HandlerStart, new Flag[locals + (handler.HandlerType == ExceptionHandlerType.Finally ? 0 : 1)]);
        while (m_next.TryPop(out Instruction? at))
            Pass(at);
        foreach (Instruction at in m_body.Instructions.Where(m_before.ContainsKey))
        {
            if (at.Operand is MethodReference called && HpcTarget.Needed(called) is { } feature && !m_target.Has(feature))
            {
                yield return (at, $"calls {called.DeclaringType.Name}.{called.Name} where this method has not found " +
                    $"Is{feature}Supported to be true");
            }
            // Fine by Burst's changelog since 1.5, but Entities says that it crashes there (SIMDSearch.cs).
            bool isOnTrue = at.OpCode.Code is Code.Brtrue or Code.Brtrue_S;
            if ((isOnTrue || at.OpCode.Code is Code.Brfalse or Code.Brfalse_S)
                && m_before[at].LastOrDefault() is { Asked: { } asked } tested && isOnTrue != tested.IsOpposite)
            {
                yield return (at, $"jumps away where Is{asked}Supported is true (a negated if, ?: or ||): Burst has crashed on " +
                    "it");
            }
        }
    }

    private void Pass(Instruction at)
    {
        Flag[] before = m_before[at];
        Flag top = before.LastOrDefault();
        Flag[] after = before[..^Popped(at, before.Length - m_body.Variables.Count)];
        Code code = at.OpCode.Code;
        if (code is Code.Stloc or Code.Stloc_S or (>= Code.Stloc_0 and <= Code.Stloc_3))
        {
            int stored = code is Code.Stloc or Code.Stloc_S ? ((VariableDefinition)at.Operand).Index : code - Code.Stloc_0;
            after[stored] = m_pointedAt.Contains(stored) ? default : top;
        }
        after = after.Concat(Pushed(at, before, top)).ToArray();
        bool isJump = code is Code.Brtrue or Code.Brtrue_S or Code.Brfalse or Code.Brfalse_S;
        bool? jumps = isJump ? top.Value == (code is Code.Brtrue or Code.Brtrue_S) : null;
        bool isKnown = isJump && top.Value != null;
        if (at.Operand is Instruction target && !(isKnown && jumps == false))
            Reach(target, after);
        foreach (Instruction many in at.Operand as Instruction[] ?? Array.Empty<Instruction>())
            Reach(many, after);
        bool hasMore = at.OpCode.FlowControl is not (FlowControl.Branch or FlowControl.Return or FlowControl.Throw);
        if (hasMore && !(isKnown && jumps == true) && at.Next != null)
            Reach(at.Next, after);
    }

    private void Reach(Instruction at, Flag[] with)
    {
        if (!m_before.TryGetValue(at, out Flag[]? known))
        {
            m_before[at] = with;
            m_next.Push(at);
            return;
        }
        // What two ways do not agree on is not known.
        Flag[] both = known.Zip(with, (a, b) => a == b ? a : default).ToArray();
        if (both.SequenceEqual(known))
            return;
        m_before[at] = both;
        m_next.Push(at);
    }

    private IEnumerable<Flag> Pushed(Instruction at, Flag[] before, Flag top)
    {
        switch (at.OpCode.Code)
        {
            case Code.Call when HpcTarget.Asked((MethodReference)at.Operand) is { } feature:
                return new[] { new Flag(m_target.Has(feature), feature, false) };
            case Code.Ldc_I4_0 or Code.Ldc_I4_1:
                return new[] { new Flag(at.OpCode.Code == Code.Ldc_I4_1, null, false) };
            case Code.Ldloc or Code.Ldloc_S:
                return new[] { before[((VariableDefinition)at.Operand).Index] };
            case >= Code.Ldloc_0 and <= Code.Ldloc_3:
                return new[] { before[at.OpCode.Code - Code.Ldloc_0] };
            case Code.Dup:
                return new[] { top, top };
            case Code.Ceq when top is { Value: false, Asked: null } && before[^2].Value != null:
                Flag other = before[^2];
                return new[] { new Flag(!other.Value, other.Asked, !other.IsOpposite) };
        }
        if (at.OpCode.StackBehaviourPush != StackBehaviour.Varpush)
            return new Flag[Parts(at.OpCode.StackBehaviourPush, "Push0")];
        TypeReference returned = ((IMethodSignature)at.Operand).ReturnType;
        while (returned is IModifierType modified)
            returned = modified.ElementType;
        return new Flag[returned.MetadataType == MetadataType.Void ? 0 : 1];
    }

    private static int Popped(Instruction at, int depth)
    {
        StackBehaviour pop = at.OpCode.StackBehaviourPop;
        if (pop == StackBehaviour.PopAll || at.OpCode.FlowControl is FlowControl.Return or FlowControl.Throw)
            return depth;
        if (pop != StackBehaviour.Varpop)
            return Parts(pop, "Pop0");
        var called = (IMethodSignature)at.Operand;
        bool hasObject = called.HasThis && at.OpCode.Code != Code.Newobj;
        return called.Parameters.Count + (hasObject ? 1 : 0) + (at.OpCode.Code == Code.Calli ? 1 : 0);
    }

    private static int Parts(StackBehaviour behaviour, string none) =>
        behaviour.ToString() == none ? 0 : behaviour.ToString().Split('_').Length;
}
