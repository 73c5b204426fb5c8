using System.Reflection.Emit;

namespace StandIns.Safety;

/// <summary>Where fields lie in a struct, as the runtime laid it out (not as it would be marshalled).</summary>
static unsafe class FieldOffsets
{
    internal static int[] Of(Type root, IReadOnlyList<FieldInfo[]> paths)
    {
        var offsets = new int[paths.Count];
        if (paths.Count == 0)
            return offsets;
        var method = new DynamicMethod("Offsets", typeof(void), new[] { typeof(byte*), typeof(int*) }, root, true);
        ILGenerator il = method.GetILGenerator();
        for (int i = 0; i < paths.Count; i++)
        {
            il.Emit(OpCodes.Ldarg_1);
            il.Emit(OpCodes.Ldc_I4, i * sizeof(int));
            il.Emit(OpCodes.Conv_I);
            il.Emit(OpCodes.Add);
            il.Emit(OpCodes.Ldarg_0);
            foreach (FieldInfo field in paths[i])
                il.Emit(OpCodes.Ldflda, field);
            il.Emit(OpCodes.Conv_U);
            il.Emit(OpCodes.Ldarg_0);
            il.Emit(OpCodes.Sub);
            il.Emit(OpCodes.Conv_I4);
            il.Emit(OpCodes.Stind_I4);
        }
        il.Emit(OpCodes.Ret);
        var compute = (Compute)method.CreateDelegate(typeof(Compute));
        // The address is never followed, but it must not look like null.
        byte* somewhere = stackalloc byte[16];
        fixed (int* results = offsets)
            compute(somewhere, results);
        return offsets;
    }

    delegate void Compute(byte* at, int* offsets);
}
