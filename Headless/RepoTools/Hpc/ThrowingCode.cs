namespace FastPoints.RepoTools.Hpc;

/// <summary>
/// The instructions from which every way leads to a throw. Burst makes an abort of them and takes the message from the
/// constructor's literals, so what only makes an exception's message is never run.
/// </summary>
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
        switch (instruction.OpCode.FlowControl)
        {
            case FlowControl.Throw:
                return true;
            case FlowControl.Return:
                return false;
            case FlowControl.Branch:
                return throwing.Contains((Instruction)instruction.Operand);
            case FlowControl.Cond_Branch when instruction.Operand is Instruction target:
                return Next() && throwing.Contains(target);
            case FlowControl.Cond_Branch:
                return Next() && System.Array.TrueForAll((Instruction[])instruction.Operand, throwing.Contains);
            default:
                return Next();
        }
    }
}
