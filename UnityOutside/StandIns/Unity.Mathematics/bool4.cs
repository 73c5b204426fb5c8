namespace Unity.Mathematics;

public struct bool4 : IEquatable<bool4>
{
    [MarshalAs(UnmanagedType.U1)] public bool x;
    [MarshalAs(UnmanagedType.U1)] public bool y;
    [MarshalAs(UnmanagedType.U1)] public bool z;
    [MarshalAs(UnmanagedType.U1)] public bool w;

    [MethodImpl(Inline)] public bool4(bool x, bool y, bool z, bool w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);

    [MethodImpl(Inline)]
    public static bool4 operator &(bool4 lhs, bool4 rhs) => new bool4(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);

    [MethodImpl(Inline)] public bool Equals(bool4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is bool4 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        (x ? 0xC53F4755u : 0x5FFF6B19u) + (y ? 0x6985C229u : 0x5E6CBF3Bu) +
        (z ? 0xE133B0B3u : 0xB546F2A5u) + (w ? 0xC3E0A3B9u : 0xBBCF63E7u));

    public override string ToString() => $"bool4({x}, {y}, {z}, {w})";
}
