namespace UnityOutside.Hpc;

internal static class LoopCode
{
    internal static bool Has(Instruction instruction)
    {
        var seen = new HashSet<Instruction>();
        var next = new Stack<Instruction>(After(instruction));
        while (next.TryPop(out Instruction? at))
        {
            if (at == instruction)
                return true;
            if (!seen.Add(at))
                continue;
            foreach (Instruction after in After(at))
                next.Push(after);
        }
        return false;
    }

    private static IEnumerable<Instruction> After(Instruction instruction)
    {
        IEnumerable<Instruction> targets = instruction.Operand switch
        {
            Instruction target => new[] { target },
            Instruction[] many => many,
            _ => Enumerable.Empty<Instruction>(),
        };
        bool hasMore = instruction.OpCode.FlowControl is not (FlowControl.Branch or FlowControl.Return or FlowControl.Throw);
        return hasMore && instruction.Next != null ? targets.Append(instruction.Next) : targets;
    }
}
