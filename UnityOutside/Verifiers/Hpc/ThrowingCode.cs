namespace UnityOutside.Hpc;

/// <summary>The instructions from which every way leads to a throw. Burst makes an abort of them and takes the message from the
/// constructor's literals, so what only makes an exception's message is never run.</summary>
internal static class ThrowingCode
{
    internal static HashSet<Instruction> Of(MethodBody body)
    {
        var throwing = new HashSet<Instruction>();
        bool changed = true;
        while (changed)
        {
            changed = false;
            for (int i = body.Instructions.Count - 1; i >= 0; i--)
            {
                Instruction instruction = body.Instructions[i];
                if (!throwing.Contains(instruction) && LeadsOnlyTo(instruction, throwing))
                    changed |= throwing.Add(instruction);
            }
        }
        return throwing;
    }

    private static bool LeadsOnlyTo(Instruction instruction, HashSet<Instruction> throwing)
    {
        bool Next() => instruction.Next != null && throwing.Contains(instruction.Next);
        return instruction.OpCode.FlowControl switch
        {
            FlowControl.Throw => true,
            FlowControl.Return => false,
            FlowControl.Branch => throwing.Contains((Instruction)instruction.Operand),
            FlowControl.Cond_Branch when instruction.Operand is Instruction target => Next() && throwing.Contains(target),
            FlowControl.Cond_Branch => Next() && System.Array.TrueForAll((Instruction[])instruction.Operand, throwing.Contains),
            _ => Next(),
        };
    }
}
