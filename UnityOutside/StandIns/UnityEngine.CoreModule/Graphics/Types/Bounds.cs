namespace UnityEngine;

public partial struct Bounds(Vector3 center, Vector3 size) : IEquatable<Bounds>, IFormattable
{
    Vector3 m_center = center;
    Vector3 m_extents = size * 0.5f;

    public Vector3 center
    {
        readonly get => m_center;
        set => m_center = value;
    }

    public Vector3 size
    {
        readonly get => m_extents * 2;
        set => m_extents = value * 0.5f;
    }

    public void Encapsulate(Bounds bounds)
    {
        Vector3 min = m_center - m_extents, max = m_center + m_extents;
        Vector3 otherMin = bounds.m_center - bounds.m_extents, otherMax = bounds.m_center + bounds.m_extents;
        for (int axis = 0; axis < 3; axis++)
        {
            min[axis] = MathF.Min(min[axis], otherMin[axis]);
            max[axis] = MathF.Max(max[axis], otherMax[axis]);
        }
        m_extents = (max - min) * 0.5f;
        m_center = min + m_extents;
    }

    public readonly bool Equals(Bounds other) => m_center.Equals(other.m_center) && m_extents.Equals(other.m_extents);
    public override readonly bool Equals(object other) => other is Bounds bounds && Equals(bounds);
    public override readonly int GetHashCode() => HashCode.Combine(m_center, m_extents);
    public override readonly string ToString() => ToString("F2", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        return "Center: " + m_center.ToString(format, formatProvider) + ", Extents: " +
            m_extents.ToString(format, formatProvider);
    }
}
