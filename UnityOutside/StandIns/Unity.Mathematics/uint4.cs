namespace Unity.Mathematics;

public struct uint4 : IEquatable<uint4>, IFormattable
{
    public uint x, y, z, w;

    [MethodImpl(Inline)] internal uint4(uint x, uint y, uint z, uint w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);

    [MethodImpl(Inline)]
    public static uint4 operator |(uint4 lhs, uint4 rhs) => new uint4(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);
    [MethodImpl(Inline)]
    public static bool4 operator ==(uint4 lhs, uint rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
    [MethodImpl(Inline)]
    public static bool4 operator ==(uint4 lhs, uint4 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
    [MethodImpl(Inline)]
    public static bool4 operator !=(uint4 lhs, uint rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
    [MethodImpl(Inline)]
    public static bool4 operator !=(uint4 lhs, uint4 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
    [MethodImpl(Inline)] public static uint4 operator ~(uint4 val) => new(~val.x, ~val.y, ~val.z, ~val.w);

    public unsafe uint this[int index]
    {
        [MethodImpl(Inline)]
        get { fixed (uint* first = &x) return first[Components.Checked(index, 4)]; }
        [MethodImpl(Inline)]
        set { fixed (uint* first = &x) first[Components.Checked(index, 4)] = value; }
    }

    [MethodImpl(Inline)] public bool Equals(uint4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is uint4 converted && Equals(converted);

    public override int GetHashCode() =>
        (int)(x * 0xB492BF15u + y * 0xD37220E3u + z * 0x7AA2C2BDu + w * 0xE16BC89Du + 0x7AA07CD3u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("uint4", "", format, formatProvider, 4, x, y, z, w);
}
