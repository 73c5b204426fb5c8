namespace StandIns.Graphics;

/// <summary>Fills constant buffers from what is set by name; what is not set is zero.</summary>
static unsafe class ConstantWriter
{
    internal static void Write(ShaderResource block, in PropertyScope scope, byte* target)
    {
        foreach (ShaderMember member in block.Members)
            if (scope.TryGet(member.NameId, out PropertyValue value))
                Write(member, value, target + member.Offset);
    }

    static void Write(ShaderMember member, in PropertyValue value, byte* target)
    {
        int bytes = member.End - member.Offset;
        switch (value.Kind)
        {
            case PropertyKind.Matrix:
                fixed (float* first = &value.Matrix.m00)
                    Buffer.MemoryCopy(first, target, bytes, Math.Min(bytes, 64));
                break;
            case PropertyKind.Int:
                if (member.IsFloat)
                    *(float*)target = value.Int;
                else
                    *(int*)target = value.Int;
                break;
            case PropertyKind.Float:
                WriteComponents(member, value.Vector, 1, target);
                break;
            case PropertyKind.Vector:
                WriteComponents(member, value.Vector, member.Rows, target);
                break;
            default:
                throw new InvalidOperationException($"{member.Name} is a constant, and a {value.Kind} is set under that "
                    + $"name");
        }
    }

    // Where the shader has whole numbers, a float becomes one.
    static void WriteComponents(ShaderMember member, Vector4 value, int count, byte* target)
    {
        for (int i = 0; i < count; i++)
            if (member.IsFloat)
                ((float*)target)[i] = value[i];
            else
                ((int*)target)[i] = unchecked((int)(long)value[i]);
    }
}
