namespace Unity.Mathematics;

public struct bool3 : IEquatable<bool3>
{
    [MarshalAs(UnmanagedType.U1)] public bool x;
    [MarshalAs(UnmanagedType.U1)] public bool y;
    [MarshalAs(UnmanagedType.U1)] public bool z;

    [MethodImpl(Inline)] public bool3(bool x, bool y, bool z) => (this.x, this.y, this.z) = (x, y, z);

    [MethodImpl(Inline)] public bool Equals(bool3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is bool3 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        (x ? 0xAF816615u : 0xA1E92D39u) + (y ? 0x9AF8D62Du : 0x4583C801u) + (z ? 0xE3600729u : 0x9536A0F5u));

    public override string ToString() => $"bool3({x}, {y}, {z})";
}
