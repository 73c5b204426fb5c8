namespace StandIns.Graphics;

enum PropertyKind : byte
{
    Float,
    Int,
    Ints,
    Vector,
    Matrix,
    Floats,
    Buffer,
    Texture,
}

struct PropertyValue
{
    internal PropertyKind Kind;
    internal bool IsDepth;
    internal int Int;
    /// <summary>A float is in x; Ints has its bits here.</summary>
    internal Vector4 Vector;
    internal Matrix4x4 Matrix;
    internal object Reference;

    internal static PropertyValue Of(float value) =>
        new PropertyValue { Kind = PropertyKind.Float, Vector = new Vector4(value, 0, 0, 0) };

    internal static PropertyValue Of(int value) => new PropertyValue { Kind = PropertyKind.Int, Int = value };

    internal static PropertyValue Of(int[] values)
    {
        if (values.Length > 4)
            throw new System.ArgumentException("More than four whole numbers under one name are not supported", nameof(values));
        PropertyValue value = default;
        value.Kind = PropertyKind.Ints;
        for (int i = 0; i < values.Length; i++)
            value.Vector[i] = System.BitConverter.Int32BitsToSingle(values[i]);
        return value;
    }

    internal static PropertyValue Of(Vector4 value) => new PropertyValue { Kind = PropertyKind.Vector, Vector = value };
    internal static PropertyValue Of(in Matrix4x4 value) => new PropertyValue { Kind = PropertyKind.Matrix, Matrix = value };
    internal static PropertyValue Of(GraphicsBuffer value) => new PropertyValue { Kind = PropertyKind.Buffer, Reference = value };

    internal static PropertyValue Of(Texture value, bool isDepth = false) =>
        new PropertyValue { Kind = PropertyKind.Texture, Reference = value, IsDepth = isDepth };
}
