namespace StandIns.Graphics;

enum PropertyKind : byte
{
    Float,
    Int,
    Vector,
    Matrix,
    Buffer,
    Texture,
}

struct PropertyValue
{
    internal PropertyKind Kind;
    internal bool IsDepth;
    internal int Int;
    internal Vector4 Vector; // A float is in x.
    internal Matrix4x4 Matrix;
    internal object Reference;

    internal static PropertyValue Of(float value) =>
        new PropertyValue { Kind = PropertyKind.Float, Vector = new Vector4(value, 0, 0, 0) };

    internal static PropertyValue Of(int value) => new PropertyValue { Kind = PropertyKind.Int, Int = value };

    internal static PropertyValue Of(Vector4 value) => new PropertyValue { Kind = PropertyKind.Vector, Vector = value };
    internal static PropertyValue Of(in Matrix4x4 value) => new PropertyValue { Kind = PropertyKind.Matrix, Matrix = value };
    internal static PropertyValue Of(GraphicsBuffer value) => new PropertyValue { Kind = PropertyKind.Buffer, Reference = value };

    internal static PropertyValue Of(Texture value, bool isDepth = false) =>
        new PropertyValue { Kind = PropertyKind.Texture, Reference = value, IsDepth = isDepth };
}
