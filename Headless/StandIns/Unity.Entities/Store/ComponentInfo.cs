using Unity.Collections.LowLevel.Unsafe;
using Unity.Entities;

namespace StandIns.Entities;

/// <summary>What the store knows of a component type.</summary>
sealed class ComponentInfo
{
    static readonly MethodInfo s_sizeOf = typeof(UnsafeUtility).GetMethod(nameof(UnsafeUtility.SizeOf), Type.EmptyTypes);

    public ComponentInfo(Type type)
    {
        Type = type;
        IsManaged = type.IsClass;
        if (!typeof(IComponentData).IsAssignableFrom(type) && !IsManaged)
            throw new ArgumentException("All ComponentType must be known at compile time: " + type + " is no IComponentData");
        IsEnableable = typeof(IEnableableComponent).IsAssignableFrom(type);
        IsCleanup = typeof(ICleanupComponentData).IsAssignableFrom(type);
        // A struct without fields is a tag: it takes no memory.
        bool isTag = type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).Length == 0;
        SizeBytes = IsManaged || isTag ? 0 : (int)s_sizeOf.MakeGenericMethod(type).Invoke(null, null);
    }

    public Type Type { get; }
    public bool IsManaged { get; }
    public bool IsEnableable { get; }
    public bool IsCleanup { get; }
    public int SizeBytes { get; }
}
