namespace UnityEngine;

public struct Color : IEquatable<Color>, IFormattable
{
    public float r;
    public float g;
    public float b;
    public float a;

    public Color(float r, float g, float b, float a) => (this.r, this.g, this.b, this.a) = (r, g, b, a);
    public Color(float r, float g, float b) : this(r, g, b, 1) { }

    public static Color black => new Color(0, 0, 0);
    public static Color white => new Color(1, 1, 1);
    public static Color clear => default;
    public static Color red => new Color(1, 0, 0);
    public static Color green => new Color(0, 1, 0);
    public static Color blue => new Color(0, 0, 1);

    public static implicit operator Vector4(Color c) => new Vector4(c.r, c.g, c.b, c.a);
    public static implicit operator Color(Vector4 v) => new Color(v.x, v.y, v.z, v.w);
    public static bool operator ==(Color lhs, Color rhs) => (Vector4)lhs == (Vector4)rhs;
    public static bool operator !=(Color lhs, Color rhs) => !(lhs == rhs);
    public readonly bool Equals(Color other) => ((Vector4)this).Equals(other);
    public override readonly bool Equals(object other) => other is Color color && Equals(color);
    public override readonly int GetHashCode() => ((Vector4)this).GetHashCode();
    public override readonly string ToString() => ToString("F3", CultureInfo.InvariantCulture);

    public readonly string ToString(string format, IFormatProvider formatProvider) =>
        "RGBA" + ((Vector4)this).ToString(format, formatProvider);
}
