namespace StandIns.Entities;

sealed class ComponentInfo
{
    static readonly MethodInfo s_sizeOf = typeof(UnsafeUtility).GetMethod(nameof(UnsafeUtility.SizeOf), Type.EmptyTypes);

    public ComponentInfo(Type type)
    {
        Type = type;
        IsBuffer = typeof(IBufferElementData).IsAssignableFrom(type);
        // Entities 6.7 has no managed components any more.
        if (!type.IsValueType || !typeof(IComponentData).IsAssignableFrom(type) && !IsBuffer &&
            !typeof(ISharedComponentData).IsAssignableFrom(type))
            throw new ArgumentException("All ComponentType must be known at compile time: " + type + " is no struct that is an " +
                "IComponentData or IBufferElementData");
        IsEnableable = typeof(IEnableableComponent).IsAssignableFrom(type);
        IsCleanup = typeof(ICleanupComponentData).IsAssignableFrom(type);
        // A struct without fields is a tag: it takes no memory.
        bool isTag = type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).Length == 0;
        ElementBytes = isTag ? 0 : (int)s_sizeOf.MakeGenericMethod(type).Invoke(null, null);
        SizeBytes = IsBuffer ? UnsafeUtility.SizeOf<BufferStore>() : ElementBytes;
    }

    public Type Type { get; }
    public bool IsBuffer { get; }
    public bool IsEnableable { get; }
    public bool IsCleanup { get; }
    public int SizeBytes { get; }
    public int ElementBytes { get; }
}
