namespace UnityEngine;

public struct Quaternion : IEquatable<Quaternion>, IFormattable
{
    public float x;
    public float y;
    public float z;
    public float w;

    public Quaternion(float x, float y, float z, float w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);

    /// <summary>Degrees: around Z first, then X, then Y.</summary>
    public static Quaternion Euler(float x, float y, float z) =>
        Around(Vector3.up, y) * Around(Vector3.right, x) * Around(Vector3.forward, z);

    /// <summary>Z looks along forward, X stays level.</summary>
    public static Quaternion LookRotation(Vector3 forward)
    {
        float yaw = MathF.Atan2(forward.x, forward.z), level = MathF.Sqrt(forward.x * forward.x + forward.z * forward.z);
        return Euler(-MathF.Atan2(forward.y, level) * (180 / MathF.PI), yaw * (180 / MathF.PI), 0);
    }

    public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new Quaternion(
        lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
        lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
        lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
        lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);

    public static Vector3 operator *(Quaternion rotation, Vector3 point)
    {
        var axis = new Vector3(rotation.x, rotation.y, rotation.z);
        var twice = 2 * Vector3.Cross(axis, point);
        return point + rotation.w * twice + Vector3.Cross(axis, twice);
    }

    public readonly bool Equals(Quaternion other) =>
        x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);

    public override readonly bool Equals(object other) => other is Quaternion quaternion && Equals(quaternion);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z, w);
    public override readonly string ToString() => ToString("F5", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return "(" + x.ToString(format, formatProvider) + ", " + y.ToString(format, formatProvider) + ", "
            + z.ToString(format, formatProvider) + ", " + w.ToString(format, formatProvider) + ")";
    }

    static Quaternion Around(Vector3 axis, float degrees)
    {
        float half = degrees * (MathF.PI / 360);
        axis *= MathF.Sin(half);
        return new Quaternion(axis.x, axis.y, axis.z, MathF.Cos(half));
    }
}
