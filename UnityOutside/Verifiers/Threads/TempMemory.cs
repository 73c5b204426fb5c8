namespace UnityOutside.Threads;

internal static class TempMemory
{
    private const int Temp = 2;

    internal static bool IsTaken(CodeIndex code, MethodDefinition method, Instruction call)
    {
        var called = (MethodReference)call.Operand;
        int first = StackFlow.ArgumentCount(call) - called.Parameters.Count;
        for (int i = 0; i < called.Parameters.Count; i++)
        {
            if (IsAllocator(called.Parameters[i].ParameterType)
                && MayBe(code, method, code.Flow(method).Argument(call, first + i), new HashSet<Instruction>()))
                return true;
        }
        return false;
    }

    private static bool IsAllocator(TypeReference type) => type.FullName == "Unity.Collections.Allocator";

    private static bool MayBe(CodeIndex code, MethodDefinition method,
        IEnumerable<Instruction> producers, HashSet<Instruction> seen)
    {
        foreach (Instruction at in producers.Where(seen.Add))
        {
            switch (at.OpCode.Code)
            {
                case Code.Ldc_I4_2:
                case Code.Ldc_I4 when (int)at.Operand == Temp:
                case Code.Ldc_I4_S when (sbyte)at.Operand == Temp:
                    return true;
                case Code.Ldfld or Code.Ldsfld when Resolution.Of((FieldReference)at.Operand) is { } field:
                    if (code.Writes(field).Any(w => MayBe(code, w.Method, code.Flow(w.Method).Producers(w.At, 0), seen)))
                        return true;
                    break;
                default:
                    if (MethodVariables.Local(method, at) is { } local &&
                        MayBe(code, method, MethodVariables.Writes(method, local)
                        .SelectMany(w => code.Flow(method).Producers(w, 0)), seen))
                        return true;
                    break;
            }
        }
        return false;
    }
}
