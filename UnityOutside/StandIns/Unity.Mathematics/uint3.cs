namespace Unity.Mathematics;

public struct uint3 : IEquatable<uint3>, IFormattable
{
    public uint x, y, z;

    [MethodImpl(Inline)] internal uint3(uint v) => x = y = z = v;
    [MethodImpl(Inline)] public uint3(uint x, uint y, uint z) => (this.x, this.y, this.z) = (x, y, z);

    [MethodImpl(Inline)] public static implicit operator uint3(uint v) => new(v);
    [MethodImpl(Inline)] public static uint3 operator +(uint lhs, uint3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(Inline)] public static uint3 operator +(uint3 lhs, uint rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(Inline)] public static uint3 operator +(uint3 lhs, uint3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(Inline)] public static uint3 operator /(uint3 lhs, uint rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);

    public unsafe uint this[int index]
    {
        [MethodImpl(Inline)]
        get { fixed (uint* first = &x) return first[Components.Checked(index, 3)]; }
        [MethodImpl(Inline)]
        set { fixed (uint* first = &x) first[Components.Checked(index, 3)] = value; }
    }

    [MethodImpl(Inline)] public bool Equals(uint3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is uint3 converted && Equals(converted);
    public override int GetHashCode() => (int)(x * 0xCD266C89u + y * 0xF1852A33u + z * 0x77E35E77u + 0x863E3729u);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("uint3", "", format, formatProvider, 3, x, y, z);
}
