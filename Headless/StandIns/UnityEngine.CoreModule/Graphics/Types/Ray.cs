namespace UnityEngine
{
    public struct Ray : IFormattable
    {
        Vector3 m_origin;
        Vector3 m_direction;

        public Ray(Vector3 origin, Vector3 direction)
        {
            m_origin = origin;
            m_direction = direction.normalized;
        }

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
            return "Origin: " + m_origin.ToString(format, formatProvider) + ", Dir: "
                + m_direction.ToString(format, formatProvider);
        }
    }
}
