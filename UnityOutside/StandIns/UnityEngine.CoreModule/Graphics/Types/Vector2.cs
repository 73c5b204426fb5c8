namespace UnityEngine;

public struct Vector2 : IEquatable<Vector2>, IFormattable
{
    public float x;
    public float y;

    public Vector2(float x, float y) => (this.x, this.y) = (x, y);

    public float sqrMagnitude => x * x + y * y;

    public static Vector2 operator +(Vector2 a, Vector2 b) => new Vector2(a.x + b.x, a.y + b.y);
    public static Vector2 operator -(Vector2 a, Vector2 b) => new Vector2(a.x - b.x, a.y - b.y);
    public static Vector2 operator -(Vector2 a) => new Vector2(-a.x, -a.y);
    public static Vector2 operator *(Vector2 a, float d) => new Vector2(a.x * d, a.y * d);
    public static Vector2 operator *(float d, Vector2 a) => a * d;
    public static Vector2 operator /(Vector2 a, float d) => new Vector2(a.x / d, a.y / d);
    public static bool operator ==(Vector2 lhs, Vector2 rhs) => (lhs - rhs).sqrMagnitude < 1e-10f;
    public static bool operator !=(Vector2 lhs, Vector2 rhs) => !(lhs == rhs);
    public static implicit operator Vector2(Vector3 v) => new Vector2(v.x, v.y);
    public static implicit operator Vector3(Vector2 v) => new Vector3(v.x, v.y, 0);
    public readonly bool Equals(Vector2 other) => x.Equals(other.x) && y.Equals(other.y);
    public override readonly bool Equals(object other) => other is Vector2 vector && Equals(vector);
    public override readonly int GetHashCode() => HashCode.Combine(x, y);
    public override readonly string ToString() => ToString("F2", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return "(" + x.ToString(format, formatProvider) + ", " + y.ToString(format, formatProvider) + ")";
    }
}
