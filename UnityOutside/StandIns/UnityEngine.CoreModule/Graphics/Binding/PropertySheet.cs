namespace StandIns.Graphics;

sealed class PropertySheet
{
    internal static readonly PropertySheet Global = new PropertySheet();

    readonly Dictionary<int, PropertyValue> m_values = new Dictionary<int, PropertyValue>();

    internal void Clear() => m_values.Clear();

    internal void CopyFrom(PropertySheet other)
    {
        m_values.Clear();
        foreach (KeyValuePair<int, PropertyValue> pair in other.m_values)
            m_values.Add(pair.Key, pair.Value);
    }

    internal bool TryGet(int name, out PropertyValue value) => m_values.TryGetValue(name, out value);
    internal void Set(int name, in PropertyValue value) => m_values[name] = value;

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
