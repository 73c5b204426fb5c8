namespace UnityEngine;

public struct Vector3 : IEquatable<Vector3>, IFormattable
{
    public float x;
    public float y;
    public float z;

    public Vector3(float x, float y, float z) => (this.x, this.y, this.z) = (x, y, z);
    public Vector3(float x, float y) : this(x, y, 0) { }

    public static Vector3 zero => default;
    public static Vector3 one => new Vector3(1, 1, 1);
    public static Vector3 up => new Vector3(0, 1, 0);
    public static Vector3 right => new Vector3(1, 0, 0);
    public static Vector3 forward => new Vector3(0, 0, 1);
    public float magnitude => MathF.Sqrt(sqrMagnitude);
    public float sqrMagnitude => x * x + y * y + z * z;
    public Vector3 normalized => magnitude > 1e-5f ? this / magnitude : zero;

    public float this[int index]
    {
        get => SystemUnsafe.Add(ref x, CheckIndex(index));
        set => SystemUnsafe.Add(ref x, CheckIndex(index)) = value;
    }

    static int CheckIndex(int index) =>
        (uint)index < 3 ? index : throw new IndexOutOfRangeException("Invalid Vector3 index!");

    public static Vector3 Scale(Vector3 a, Vector3 b) => new Vector3(a.x * b.x, a.y * b.y, a.z * b.z);
    public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;

    public static Vector3 Cross(Vector3 lhs, Vector3 rhs) =>
        new Vector3(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);

    public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
    public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
    public static Vector3 operator -(Vector3 a) => new Vector3(-a.x, -a.y, -a.z);
    public static Vector3 operator *(Vector3 a, float d) => new Vector3(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator *(float d, Vector3 a) => a * d;
    public static Vector3 operator /(Vector3 a, float d) => new Vector3(a.x / d, a.y / d, a.z / d);
    public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < 1e-10f;
    public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);
    public readonly bool Equals(Vector3 other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z);
    public override readonly bool Equals(object other) => other is Vector3 vector && Equals(vector);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z);
    public override readonly string ToString() => ToString("F2", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return "(" + x.ToString(format, formatProvider) + ", " + y.ToString(format, formatProvider) + ", "
            + z.ToString(format, formatProvider) + ")";
    }
}
