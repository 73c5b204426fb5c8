namespace Unity.Mathematics;

public struct float3 : IEquatable<float3>, IFormattable
{
    public float x, y, z;

    public static readonly float3 zero;

    [MethodImpl(Inline)] public float3(int v) => x = y = z = v;
    [MethodImpl(Inline)] internal float3(float v) => x = y = z = v;
    [MethodImpl(Inline)] public float3(float x, float y, float z) => (this.x, this.y, this.z) = (x, y, z);
    [MethodImpl(Inline)] internal float3(uint v) => x = y = z = v;
    [MethodImpl(Inline)] internal float3(double3 v) => (x, y, z) = ((float)v.x, (float)v.y, (float)v.z);
    [MethodImpl(Inline)] public float3(float2 xy, float z) => (x, y, this.z) = (xy.x, xy.y, z);

    [MethodImpl(Inline)] public static explicit operator float3(double3 v) => new(v);
    [MethodImpl(Inline)] public static implicit operator float3(int v) => new(v);
    [MethodImpl(Inline)] public static implicit operator float3(float v) => new(v);
    [MethodImpl(Inline)] public static implicit operator float3(uint v) => new(v);
    [MethodImpl(Inline)] public static float3 operator +(float lhs, float3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(Inline)] public static float3 operator +(float3 lhs, float rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(Inline)]
    public static float3 operator +(float3 lhs, float3 rhs) => new float3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(Inline)] public static float3 operator /(float lhs, float3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    [MethodImpl(Inline)] public static float3 operator /(float3 lhs, float rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    [MethodImpl(Inline)]
    public static float3 operator /(float3 lhs, float3 rhs) => new float3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    [MethodImpl(Inline)] public static bool3 operator >(float3 lhs, float rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
    [MethodImpl(Inline)] public static bool3 operator >=(float3 lhs, float rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
    [MethodImpl(Inline)] public static bool3 operator <(float3 lhs, float rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
    [MethodImpl(Inline)] public static bool3 operator <=(float3 lhs, float rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
    [MethodImpl(Inline)] public static float3 operator *(float lhs, float3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    [MethodImpl(Inline)] public static float3 operator *(float3 lhs, float rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    [MethodImpl(Inline)]
    public static float3 operator *(float3 lhs, float3 rhs) => new float3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    [MethodImpl(Inline)] public static float3 operator -(float lhs, float3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    [MethodImpl(Inline)] public static float3 operator -(float3 lhs, float rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    [MethodImpl(Inline)]
    public static float3 operator -(float3 lhs, float3 rhs) => new float3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    [MethodImpl(Inline)] public static float3 operator -(float3 val) => new(-val.x, -val.y, -val.z);

    public unsafe float this[int index]
    {
        [MethodImpl(Inline)]
        get { fixed (float* first = &x) return first[Components.Checked(index, 3)]; }
        [MethodImpl(Inline)]
        set { fixed (float* first = &x) first[Components.Checked(index, 3)] = value; }
    }

    [MethodImpl(Inline)] public bool Equals(float3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is float3 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.asuint(x) * 0x9B13B92Du + math.asuint(y) * 0x4ABF0813u + math.asuint(z) * 0x86068063u + 0xD75513F9u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("float3", "f", format, formatProvider, 3, x, y, z);

    public float2 xy
    {
        [MethodImpl(Inline)]
        get => new float2(x, y);
        [MethodImpl(Inline)]
        set { x = value.x; y = value.y; }
    }

    internal float3 yzx
    {
        [MethodImpl(Inline)]
        get => new float3(y, z, x);
    }
}
