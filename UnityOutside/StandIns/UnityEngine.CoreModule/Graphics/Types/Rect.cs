namespace UnityEngine;

public struct Rect(float x, float y, float width, float height) : IEquatable<Rect>, IFormattable
{
    float m_x = x;
    float m_y = y;
    float m_width = width;
    float m_height = height;

    public float x
    {
        readonly get => m_x;
        set => m_x = value;
    }

    public float y
    {
        readonly get => m_y;
        set => m_y = value;
    }

    public float width
    {
        readonly get => m_width;
        set => m_width = value;
    }

    public float height
    {
        readonly get => m_height;
        set => m_height = value;
    }

    public static bool operator ==(Rect lhs, Rect rhs) =>
        lhs.m_x == rhs.m_x && lhs.m_y == rhs.m_y && lhs.m_width == rhs.m_width && lhs.m_height == rhs.m_height;

    public static bool operator !=(Rect lhs, Rect rhs) => !(lhs == rhs);

    public readonly bool Equals(Rect other) =>
        m_x.Equals(other.m_x) && m_y.Equals(other.m_y) && m_width.Equals(other.m_width) && m_height.Equals(other.m_height);

    public override readonly bool Equals(object other) => other is Rect rect && Equals(rect);
    public override readonly int GetHashCode() => HashCode.Combine(m_x, m_y, m_width, m_height);
    public override readonly string ToString() => ToString("F2", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return $"(x:{m_x.ToString(format, formatProvider)}, y:{m_y.ToString(format, formatProvider)}, "
            + $"width:{m_width.ToString(format, formatProvider)}, height:{m_height.ToString(format, formatProvider)})";
    }
}
