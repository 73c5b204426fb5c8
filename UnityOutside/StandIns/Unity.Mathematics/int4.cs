namespace Unity.Mathematics;

public struct int4 : IEquatable<int4>, IFormattable
{
    public int x, y, z, w;

    [MethodImpl(Inline)] public int4(int x, int y, int z, int w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);
    [MethodImpl(Inline)] public int4(int3 xyz, int w) => (x, y, z, this.w) = (xyz.x, xyz.y, xyz.z, w);

    [MethodImpl(Inline)]
    public static bool4 operator ==(int4 lhs, int4 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
    [MethodImpl(Inline)]
    public static bool4 operator !=(int4 lhs, int4 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);

    [MethodImpl(Inline)] public bool Equals(int4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is int4 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        (uint)x * 0x6E050B01u + (uint)y * 0x750FDBF5u + (uint)z * 0x7F3DD499u + (uint)w * 0x52EAAEBBu + 0x4599C793u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("int4", "", format, formatProvider, 4, x, y, z, w);

    public int3 xyz
    {
        [MethodImpl(Inline)]
        get => new int3(x, y, z);
        [MethodImpl(Inline)]
        set { x = value.x; y = value.y; z = value.z; }
    }
}
