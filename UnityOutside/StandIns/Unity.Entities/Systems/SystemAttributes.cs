namespace Unity.Entities;

[AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Struct, Inherited = false)]
public sealed class DisableAutoCreationAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct, AllowMultiple = true)]
public class UpdateAfterAttribute : Attribute
{
    public UpdateAfterAttribute(Type systemType) => SystemType = systemType
        ?? throw new ArgumentNullException(nameof(systemType));

    public Type SystemType { get; }
}

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct, AllowMultiple = true)]
public class UpdateBeforeAttribute : Attribute
{
    public UpdateBeforeAttribute(Type systemType) => SystemType = systemType
        ?? throw new ArgumentNullException(nameof(systemType));

    public Type SystemType { get; }
}

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct, AllowMultiple = true)]
public class UpdateInGroupAttribute : Attribute
{
    public bool OrderFirst;
    public bool OrderLast;

    public UpdateInGroupAttribute(Type groupType) => GroupType = groupType ?? throw new ArgumentNullException(nameof(groupType));

    public Type GroupType { get; }
}

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct)]
public class WorldSystemFilterAttribute(WorldSystemFilterFlags flags,
    WorldSystemFilterFlags childDefaultFlags = WorldSystemFilterFlags.Default) : Attribute
{
    public WorldSystemFilterFlags FilterFlags = flags;
    public WorldSystemFilterFlags ChildDefaultFilterFlags = childDefaultFlags;
}

[Flags]
public enum WorldSystemFilterFlags : uint
{
    Default = 1,
    Disabled = 2,
    Editor = 64,
    LocalSimulation = 256,
    Presentation = 4096,
    All = 4294967295,
}
