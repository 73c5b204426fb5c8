namespace Unity.Entities;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct, AllowMultiple = true)]
public class UpdateBeforeAttribute : Attribute
{
    public UpdateBeforeAttribute(Type systemType) => SystemType = systemType
        ?? throw new ArgumentNullException(nameof(systemType));

    public Type SystemType { get; }
}
