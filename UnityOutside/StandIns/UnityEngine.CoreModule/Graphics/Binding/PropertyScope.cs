namespace StandIns.Graphics;

/// <summary>Where a draw or dispatch looks a name up: the nearest sheet that has it wins.</summary>
readonly struct PropertyScope
{
    readonly PropertySheet m_near;
    readonly PropertySheet m_far;
    readonly PropertySheet m_defaults;

    /// <param name="near">A property block, or a kernel's buffers; may be null.</param>
    /// <param name="defaults">What a shader's Properties say, before the globals, as in Unity; may be null.</param>
    internal PropertyScope(PropertySheet near, PropertySheet far, PropertySheet defaults = null) =>
        (m_near, m_far, m_defaults) = (near, far, defaults);

    internal bool TryGet(int name, out PropertyValue value)
    {
        if (m_near != null && m_near.TryGet(name, out value))
            return true;
        if (m_far.TryGet(name, out value))
            return true;
        if (m_defaults != null && m_defaults.TryGet(name, out value))
            return true;
        return PropertySheet.Global.TryGet(name, out value);
    }
}
