namespace UnityEngine;

public struct Vector4 : IEquatable<Vector4>, IFormattable
{
    public float x;
    public float y;
    public float z;
    public float w;

    public Vector4(float x, float y, float z, float w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);
    public Vector4(float x, float y) : this(x, y, 0, 0) { }
    public Vector4(float x, float y, float z) : this(x, y, z, 0) { }

    public static Vector4 one => new Vector4(1, 1, 1, 1);
    public float sqrMagnitude => x * x + y * y + z * z + w * w;

    public float this[int index]
    {
        get => SystemUnsafe.Add(ref x, CheckIndex(index));
        set => SystemUnsafe.Add(ref x, CheckIndex(index)) = value;
    }

    static int CheckIndex(int index) =>
        (uint)index < 4 ? index : throw new IndexOutOfRangeException("Invalid Vector4 index!");

    public static Vector4 operator +(Vector4 a, Vector4 b) => new Vector4(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
    public static Vector4 operator -(Vector4 a, Vector4 b) => new Vector4(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
    public static Vector4 operator -(Vector4 a) => new Vector4(-a.x, -a.y, -a.z, -a.w);
    public static Vector4 operator *(Vector4 a, float d) => new Vector4(a.x * d, a.y * d, a.z * d, a.w * d);
    public static Vector4 operator *(float d, Vector4 a) => a * d;
    public static Vector4 operator /(Vector4 a, float d) => new Vector4(a.x / d, a.y / d, a.z / d, a.w / d);
    public static bool operator ==(Vector4 lhs, Vector4 rhs) => (lhs - rhs).sqrMagnitude < 1e-10f;
    public static bool operator !=(Vector4 lhs, Vector4 rhs) => !(lhs == rhs);
    public static implicit operator Vector4(Vector3 v) => new Vector4(v.x, v.y, v.z, 0);
    public static implicit operator Vector3(Vector4 v) => new Vector3(v.x, v.y, v.z);
    public static implicit operator Vector4(Vector2 v) => new Vector4(v.x, v.y, 0, 0);
    public static implicit operator Vector2(Vector4 v) => new Vector2(v.x, v.y);

    public readonly bool Equals(Vector4 other) =>
        x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);

    public override readonly bool Equals(object other) => other is Vector4 vector && Equals(vector);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z, w);
    public override readonly string ToString() => ToString("F2", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return "(" + x.ToString(format, formatProvider) + ", " + y.ToString(format, formatProvider) + ", "
            + z.ToString(format, formatProvider) + ", " + w.ToString(format, formatProvider) + ")";
    }
}
