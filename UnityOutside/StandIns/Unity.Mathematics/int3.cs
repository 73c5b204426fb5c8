namespace Unity.Mathematics;

public struct int3 : IEquatable<int3>, IFormattable
{
    public int x, y, z;

    [MethodImpl(Inline)] public int3(int v) => x = y = z = v;
    [MethodImpl(Inline)] public int3(int x, int y, int z) => (this.x, this.y, this.z) = (x, y, z);
    [MethodImpl(Inline)] internal int3(double3 v) => (x, y, z) = ((int)v.x, (int)v.y, (int)v.z);
    [MethodImpl(Inline)] internal int3(float3 v) => (x, y, z) = ((int)v.x, (int)v.y, (int)v.z);
    [MethodImpl(Inline)] public int3(int2 xy, int z) => (x, y, this.z) = (xy.x, xy.y, z);
    [MethodImpl(Inline)] public int3(int3 xyz) => (x, y, z) = (xyz.x, xyz.y, xyz.z);

    [MethodImpl(Inline)] public static explicit operator int3(double3 v) => new(v);
    [MethodImpl(Inline)] public static explicit operator int3(float3 v) => new(v);
    [MethodImpl(Inline)] public static implicit operator int3(int v) => new(v);
    [MethodImpl(Inline)] public static int3 operator +(int lhs, int3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(Inline)] public static int3 operator +(int3 lhs, int rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(Inline)] public static int3 operator +(int3 lhs, int3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(Inline)] public static int3 operator -(int3 lhs, int3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    [MethodImpl(Inline)] public static bool3 operator ==(int lhs, int3 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
    [MethodImpl(Inline)] public static bool3 operator ==(int3 lhs, int rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
    [MethodImpl(Inline)]
    public static bool3 operator ==(int3 lhs, int3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    [MethodImpl(Inline)] public static bool3 operator >(int3 lhs, int rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
    [MethodImpl(Inline)] public static bool3 operator >=(int3 lhs, int rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
    [MethodImpl(Inline)] public static bool3 operator !=(int lhs, int3 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
    [MethodImpl(Inline)] public static bool3 operator !=(int3 lhs, int rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
    [MethodImpl(Inline)]
    public static bool3 operator !=(int3 lhs, int3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    [MethodImpl(Inline)] public static bool3 operator <(int3 lhs, int rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
    [MethodImpl(Inline)] public static bool3 operator <=(int3 lhs, int rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
    [MethodImpl(Inline)] public static int3 operator %(int3 lhs, int rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
    [MethodImpl(Inline)] public static int3 operator *(int3 lhs, int rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    [MethodImpl(Inline)] public static int3 operator >>(int3 x, int n) => new(x.x >> n, x.y >> n, x.z >> n);

    public unsafe int this[int index]
    {
        [MethodImpl(Inline)]
        get { fixed (int* first = &x) return first[Components.Checked(index, 3)]; }
        [MethodImpl(Inline)]
        set { fixed (int* first = &x) first[Components.Checked(index, 3)] = value; }
    }

    [MethodImpl(Inline)] public bool Equals(int3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is int3 converted && Equals(converted);

    public override int GetHashCode() =>
        (int)((uint)x * 0x4C7F6DD1u + (uint)y * 0x4822A3E9u + (uint)z * 0xAAC3C25Du + 0xD21D0945u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("int3", "", format, formatProvider, 3, x, y, z);

    public int2 xy
    {
        [MethodImpl(Inline)]
        get => new int2(x, y);
        [MethodImpl(Inline)]
        set { x = value.x; y = value.y; }
    }

    public int3 xyz
    {
        [MethodImpl(Inline)]
        get => new int3(x, y, z);
        [MethodImpl(Inline)]
        set { x = value.x; y = value.y; z = value.z; }
    }
}
