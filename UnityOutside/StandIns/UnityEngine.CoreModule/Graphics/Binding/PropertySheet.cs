namespace StandIns.Graphics;

sealed class PropertySheet
{
    internal static readonly PropertySheet Global = new PropertySheet();

    // Kept when the values are cleared: an array set anew each frame makes no garbage.
    readonly Dictionary<int, float[]> m_arrays = new Dictionary<int, float[]>();
    readonly Dictionary<int, PropertyValue> m_values = new Dictionary<int, PropertyValue>();

    internal void Clear() => m_values.Clear();

    internal void CopyFrom(PropertySheet other)
    {
        m_values.Clear();
        foreach (KeyValuePair<int, PropertyValue> pair in other.m_values)
            if (pair.Value.Kind == PropertyKind.Floats)
                Set(pair.Key, (float[])pair.Value.Reference);
            else
                m_values.Add(pair.Key, pair.Value);
    }

    internal bool TryGet(int name, out PropertyValue value) => m_values.TryGetValue(name, out value);
    internal void Set(int name, in PropertyValue value) => m_values[name] = value;

    /// <summary>Copies an array: of floats, of four for a vector, of sixteen for a matrix.</summary>
    internal void Set(int name, ReadOnlySpan<float> values)
    {
        if (!m_arrays.TryGetValue(name, out float[] array) || array.Length != values.Length)
            m_arrays[name] = array = new float[values.Length];
        values.CopyTo(array);
        m_values[name] = new PropertyValue { Kind = PropertyKind.Floats, Reference = array };
    }

    internal void Set(int name, Vector4[] values) => Set(name, MemoryMarshal.Cast<Vector4, float>(values));
    internal void Set(int name, Matrix4x4[] values) => Set(name, MemoryMarshal.Cast<Matrix4x4, float>(values));

    internal void Set(int name, GraphicsBuffer value)
    {
        if (value == null)
            m_values.Remove(name);
        else
            m_values[name] = PropertyValue.Of(value);
    }

    internal void Set(int name, Texture value, bool isDepth = false)
    {
        if (value == null)
            m_values.Remove(name);
        else
            m_values[name] = PropertyValue.Of(value, isDepth);
    }
}
