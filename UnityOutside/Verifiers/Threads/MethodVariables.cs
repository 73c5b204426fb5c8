namespace UnityOutside.Threads;

internal static class MethodVariables
{
    internal static VariableDefinition? Local(MethodDefinition method, Instruction at)
    {
        if (at.Operand is VariableDefinition variable)
            return variable;
        Code code = at.OpCode.Code;
        int index = code is >= Code.Ldloc_0 and <= Code.Ldloc_3 ? code - Code.Ldloc_0
            : code is >= Code.Stloc_0 and <= Code.Stloc_3 ? code - Code.Stloc_0 : -1;
        return index < 0 ? null : method.Body.Variables[index];
    }

    /// <summary>The index of the parameter that is loaded; 0 is the object, where the method has one.</summary>
    internal static int? Parameter(MethodDefinition method, Instruction at)
    {
        Code code = at.OpCode.Code;
        if (code is >= Code.Ldarg_0 and <= Code.Ldarg_3)
            return code - Code.Ldarg_0;
        if (code is not (Code.Ldarg or Code.Ldarg_S))
            return null;
        return ((ParameterDefinition)at.Operand).Index + (method.HasThis ? 1 : 0);
    }

    internal static IEnumerable<Instruction> Writes(MethodDefinition method, VariableDefinition local) =>
        method.Body.Instructions.Where(i => i.OpCode.Name.StartsWith("stloc", StringComparison.Ordinal) &&
            Local(method, i) == local);

    /// <summary>Whether the variable's address is taken: others may write it.</summary>
    internal static bool IsLent(MethodDefinition method, VariableDefinition local) =>
        method.Body.Instructions.Any(i => i.OpCode.Code is Code.Ldloca or Code.Ldloca_S && i.Operand == local);
}
