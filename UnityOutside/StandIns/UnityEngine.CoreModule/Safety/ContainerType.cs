namespace StandIns.Safety;

sealed class ContainerType
{
    static readonly ConcurrentDictionary<Type, ContainerType> s_types = new ConcurrentDictionary<Type, ContainerType>();

    internal readonly string Name;
    internal readonly bool IsReadOnly;
    internal readonly bool SupportsMinMax;
    // -1 if there is no such field.
    internal readonly int BufferOffset;
    internal readonly int MinIndexOffset;
    internal readonly int MaxIndexOffset;
    internal readonly int AllocatorOffset;
    internal readonly int SafetyOffset;

    ContainerType(Type type)
    {
        Name = SafetyNames.Of(type);
        IsReadOnly = type.IsDefined(typeof(NativeContainerIsReadOnlyAttribute), false);
        SupportsMinMax = type.IsDefined(typeof(NativeContainerSupportsMinMaxWriteRestrictionAttribute), false);
        string[] names = { "m_Buffer", "m_MinIndex", "m_MaxIndex", "m_AllocatorLabel", "m_Safety" };
        var paths = new List<FieldInfo[]>();
        var found = new int[names.Length];
        for (int i = 0; i < names.Length; i++)
        {
            FieldInfo field = type.GetField(names[i], JobLayout.InstanceFields);
            found[i] = field == null ? -1 : paths.Count;
            if (field != null)
                paths.Add(new[] { field });
        }
        int[] offsets = FieldOffsets.Of(type, paths);
        for (int i = 0; i < found.Length; i++)
            found[i] = found[i] < 0 ? -1 : offsets[found[i]];
        BufferOffset = found[0];
        MinIndexOffset = found[1];
        MaxIndexOffset = found[2];
        AllocatorOffset = found[3];
        SafetyOffset = found[4];
    }

    internal static bool Is(Type type) => type.IsValueType && type.IsDefined(typeof(NativeContainerAttribute), false);
    internal static ContainerType Of(Type type) => s_types.GetOrAdd(type, t => new ContainerType(t));
}
