namespace UnityEngine;

public struct Ray(Vector3 origin, Vector3 direction) : IFormattable
{
    Vector3 m_origin = origin;
    Vector3 m_direction = direction.normalized;

    public Vector3 origin
    {
        readonly get => m_origin;
        set => m_origin = value;
    }

    public Vector3 direction
    {
        readonly get => m_direction;
        set => m_direction = value.normalized;
    }

    public override readonly string ToString() => ToString("F2", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return "Origin: " + m_origin.ToString(format, formatProvider) + ", Dir: " + m_direction.ToString(format, formatProvider);
    }
}
